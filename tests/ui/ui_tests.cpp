// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>

#include <QApplication>
#include <QTest>

#include "tests/ui/ui_test.h"

namespace zscope::ui {

std::vector<UiTest>& uiTests()
{
    static std::vector<UiTest> tests;
    return tests;
}

}  // namespace zscope::ui

using namespace zscope::ui;

int main(int argc, char** argv)
{
    const std::string name  = argc > 1 ? argv[1] : "";
    const auto        found = std::ranges::find(uiTests(), name, &UiTest::name);
    if (found == uiTests().end()) {
        std::fprintf(stderr, "Say which test to run:\n");
        for (const UiTest& test : uiTests()) std::fprintf(stderr, "  %s\n", test.name.c_str());
        return 2;
    }
    qputenv("QT_QPA_PLATFORM", "offscreen");
    std::unique_ptr<QCoreApplication> application;
    if (found->needs == Needs::Window) {
        application = std::make_unique<QApplication>(argc, argv);
        QApplication::setStyle("Fusion");
    } else {
        application = std::make_unique<QCoreApplication>(argc, argv);
    }
    argv[1] = argv[0];  // Qt Test reads what follows the name
    return QTest::qExec(found->make().get(), argc - 1, argv + 1);
}
