// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/spoken.h"

#include <utility>

#include <QEvent>

namespace zscope::ui {
namespace {

class Speaker final : public QObject {
public:
    Speaker(QObject& owner, std::function<void()> say) : QObject(&owner), m_say(std::move(say))
    {
        owner.installEventFilter(this);
    }

protected:
    bool eventFilter(QObject* object, QEvent* event) override
    {
        if (event->type() == QEvent::LanguageChange && object == parent()) m_say();
        return false;
    }

private:
    std::function<void()> m_say;
};

}  // namespace

void spoken(QObject& owner, std::function<void()> say)
{
    say();
    new Speaker(owner, std::move(say));
}

}  // namespace zscope::ui
