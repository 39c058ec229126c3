// SPDX-License-Identifier: GPL-3.0-or-later
// Makes comparison sheets of the view in the window: draws, times and judges
// on a worker of its own, then writes the file.
//
// Choice     which algorithms, asked in a dialog: what the window draws with, what it is compared with, and every
//            preset
// Newest     another sheet takes the place of one that is being made
#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QString>

#include "core/measure/bench.h"
#include "ui/session/session.h"
#include "ui/session/worker.h"

class QWidget;

namespace zscope::ui {

class SheetMaker final : public QObject {
    Q_OBJECT

public:
    explicit SheetMaker(Session& session, QObject* parent = nullptr);
    ~SheetMaker() override;

    /// Two or more; the first is what the others are held against. Nothing happens without a scene.
    void make(const std::vector<BenchAlgorithm>& algorithms, const QString& file);

    /// Asks which; empty: nobody wants a sheet.
    static std::vector<BenchAlgorithm> ask(QWidget* parent, const Session& session);
    /// What a sheet of this view could hold, what is likely first; `likely`: how many of them are.
    static std::vector<BenchAlgorithm> choices(const Session& session, std::size_t& likely);

signals:
    void made(const QString& file);
    void failed(const QString& sentence);

private:
    Session&                m_session;
    std::unique_ptr<Worker> m_worker;
};

}  // namespace zscope::ui
