// SPDX-License-Identifier: GPL-3.0-or-later
// Predict mode: while it is on for a table, the next step is not shown there
// before the student has said what comes. It keeps what was asked and answered, and writes it as a table for a
// spreadsheet.
//
// Skipped    going on with a question open is an answer, too: it is kept as skipped, and is not right
// When       one step forward, by whatever key or button; a jump, a step back or another scene shows at once
// Hidden     the table, as long as its question is open; the picture and the sentence under the timeline, as long as
//            any is
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <QDateTime>
#include <QObject>

#include "ui/predict/riddle.h"

namespace zscope::ui {

class Session;

/// One question that was answered, or passed by.
struct Predicted {
    QDateTime             at;
    Topic                 topic;
    QString               scene, algorithm, grain;
    std::uint64_t         step = 0;  // from 1, as the window counts
    Riddle                riddle;
    std::optional<double> given   = {};  // nothing: passed by
    bool                  isRight = false;
};

class Predictions final : public QObject {
    Q_OBJECT

public:
    explicit Predictions(Session& session, QObject* parent = nullptr);

    bool isOn(Topic topic) const { return m_on[static_cast<std::size_t>(topic)]; }
    void setOn(Topic topic, bool on);

    /// The question that is open; nullptr: none.
    const Riddle* open(Topic topic) const;
    bool          isAnyOpen() const;
    /// What the table may show while a question is open: the snapshot of the step before. Otherwise nothing.
    std::optional<Snapshot> before(Topic topic, const Snapshot& now) const;
    /// The same of whatever shows more than one table: the picture.
    std::optional<Snapshot> before(const Snapshot& now) const;
    /// A number, or the place of a choice. The table is shown from then on.
    void answer(Topic topic, double given);
    /// What was answered last, until the next step, or was skipped by it; nullptr: nothing.
    const Predicted* last(Topic topic) const;

    const std::vector<Predicted>& all() const { return m_all; }
    int                           rightOf(Topic topic) const;
    int                           countOf(Topic topic) const;
    int                           skippedOf(Topic topic) const;
    /// As CSV: UTF-8 with a byte order mark, commas, quotes where they are needed, so that any spreadsheet opens it.
    QByteArray table() const;
    /// Writes it whole or not at all. Returns the trouble as a sentence, or nothing.
    std::optional<QString> save(const QString& file) const;

signals:
    /// Another question, answer or switch.
    void changed();

private:
    struct State {
        std::optional<Riddle>            riddle;
        std::shared_ptr<const ShownStep> before;  // what may be shown meanwhile
        std::optional<std::size_t>       last;    // of m_all
    };

    void         hear();
    void         keep(Topic topic, const ShownStep& step, std::optional<double> given);
    State&       at(Topic topic) { return m_state[static_cast<std::size_t>(topic)]; }
    const State& at(Topic topic) const { return m_state[static_cast<std::size_t>(topic)]; }

    Session&                          m_session;
    std::array<bool, kTopics.size()>  m_on{};
    std::array<State, kTopics.size()> m_state;
    std::shared_ptr<const ShownStep>  m_step;  // heard of last
    std::vector<Predicted>            m_all;
};

}  // namespace zscope::ui
