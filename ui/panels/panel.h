// SPDX-License-Identifier: GPL-3.0-or-later
// A panel shows one snapshot and asks the session for changes; it holds no truth of its own.
#pragma once

#include <QWidget>

#include "ui/session/session.h"

namespace zscope::ui {

class Panel : public QWidget {
    Q_OBJECT

public:
    explicit Panel(Session& session, QWidget* parent = nullptr) : QWidget(parent), m_session(session) {}

    virtual void present(const Snapshot& shown, Changes what) = 0;

signals:
    /// A few words for the right end of the title: what the panel is about just now.
    void summaryChanged(const QString& summary);

protected:
    Session& session() const { return m_session; }

private:
    Session& m_session;
};

}  // namespace zscope::ui
