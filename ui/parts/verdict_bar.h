// SPDX-License-Identifier: GPL-3.0-or-later
// A row of switches, one per verdict, each with its shape, colour and how
// many nodes have it: filter, legend and count in one.
#pragma once

#include <array>

#include <QWidget>

#include "core/lesson/outside_view.h"

class QToolButton;

namespace zscope::ui {

using VerdictCounts = std::array<std::size_t, 6>;  // by NodeVerdict

class VerdictBar final : public QWidget {
    Q_OBJECT

public:
    explicit VerdictBar(const VerdictSet& on, QWidget* parent = nullptr);

    const VerdictSet& chosen() const { return m_chosen; }
    /// Switches of verdicts that no node has are hidden, but for the usual four.
    void present(const VerdictCounts& counts);

signals:
    void changed(const zscope::VerdictSet& chosen);

protected:
    void changeEvent(QEvent* event) override;

private:
    void dress();

    VerdictSet                  m_chosen;
    VerdictCounts               m_counts{};
    std::array<QToolButton*, 6> m_buttons{};  // by NodeVerdict
};

}  // namespace zscope::ui
