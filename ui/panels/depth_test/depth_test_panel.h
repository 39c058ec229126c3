// SPDX-License-Identifier: GPL-3.0-or-later
// The last depth test: who came, who was there, which is nearer, and the triangle that the step is about. Between
// pixels: what is known of the picked one.
#pragma once

#include <vector>

#include "ui/panels/panel.h"

class QGridLayout;
class QLabel;

namespace zscope::ui {

struct Fact {
    QString name, value;

    friend bool operator==(const Fact&, const Fact&) = default;
};
struct DepthTestContents {
    QString           verdict;  // one sentence, or a hint while there is nothing to tell
    std::vector<Fact> facts;
};
DepthTestContents depthTestOf(const Snapshot& shown);

class DepthTestPanel final : public Panel {
    Q_OBJECT

public:
    explicit DepthTestPanel(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& shown, Changes what) override;

private:
    QLabel*              m_verdict;
    QGridLayout*         m_grid;
    std::vector<QLabel*> m_names, m_values;
};

}  // namespace zscope::ui
