// SPDX-License-Identifier: GPL-3.0-or-later
// Test classes of Qt Test in one program, each under a name: `ui_tests NAME [arguments of Qt Test]` runs one of them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QObject>

namespace zscope::ui {

enum class Needs { Window, Events };  // a QApplication | only a QCoreApplication

struct UiTest {
    std::string                               name;
    Needs                                     needs;
    std::function<std::unique_ptr<QObject>()> make;
};

std::vector<UiTest>& uiTests();

template <class Test>
struct UiTestEntry {
    UiTestEntry(std::string name, Needs needs)
    {
        uiTests().push_back({std::move(name), needs, [] { return std::make_unique<Test>(); }});
    }
};

}  // namespace zscope::ui

/// Once at the end of a file, before its moc file is included.
#define ZSCOPE_UI_TEST(Test, name, needs) \
    static const zscope::ui::UiTestEntry<Test> k##Test(name, zscope::ui::Needs::needs);
