// SPDX-License-Identifier: GPL-3.0-or-later
// What can be read, in light and in dark: contrast as it is measured, on pixels that were painted.
#include <cmath>
#include <map>

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QRegularExpression>
#include <QToolButton>

#include "tests/ui/desk.h"
#include "tests/ui/ui_test.h"
#include "ui/panels/hierarchy/depth_chart.h"
#include "ui/panels/timeline/step_track.h"
#include "ui/text/grains.h"
#include "ui/theme/theme.h"
#include "ui/view/magnifier.h"
#include "ui/window/message_bar.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

constexpr double kReadable = 4.5;  // WCAG 2.1, text of usual size
constexpr double kSeen     = 3;    // likewise, marks without letters

double luminance(const QColor& colour)
{
    const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

/// 1 to 21, as WCAG 2.1 defines it.
double contrast(const QColor& a, const QColor& b)
{
    const double brighter = std::max(luminance(a), luminance(b)), darker = std::min(luminance(a), luminance(b));
    return (brighter + 0.05) / (darker + 0.05);
}

/// The most that two colours in a part of a picture differ.
double contrastIn(const QImage& picture, const QRect& part)
{
    QColor darkest = Qt::white, brightest = Qt::black;
    for (int y = part.top(); y <= part.bottom(); ++y)
        for (int x = part.left(); x <= part.right(); ++x) {
            const QColor colour = picture.pixelColor(x, y);
            if (luminance(colour) < luminance(darkest)) darkest = colour;
            if (luminance(colour) > luminance(brightest)) brightest = colour;
        }
    return contrast(darkest, brightest);
}

/// Of the colour that covers most of a part of a picture, and the one there that is farthest from it: ground and
/// letters.
double contrastOfText(const QImage& picture, const QRect& part)
{
    std::map<QRgb, int> counts;
    for (int y = part.top(); y <= part.bottom(); ++y)
        for (int x = part.left(); x <= part.right(); ++x) ++counts[picture.pixel(x, y)];
    const QColor ground(std::ranges::max_element(counts, {}, [](const auto& count) { return count.second; })->first);
    double       most = 1;
    for (const auto& [colour, count] : counts) most = std::max(most, contrast(ground, QColor(colour)));
    return most;
}

void wear(const Desk& desk, const char* look)
{
    desk.window.findChild<QAction*>(QStringLiteral("appearance.") + look)->trigger();
}

}  // namespace

class LooksTest final : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QCoreApplication::processEvents(); }

    void theChosenRowOfAListCanBeRead()
    {
        Desk desk;
        for (const char* look : {"light", "dark"}) {
            wear(desk, look);
            for (auto* box : desk.window.findChildren<QComboBox*>()) {
                if (!box->isVisible() || !box->isEnabled()) continue;
                box->showPopup();
                QTest::qWait(20);
                const QRect  row     = box->view()->visualRect(box->view()->currentIndex());
                const QImage picture = box->view()->viewport()->grab().toImage();
                const double found   = contrastOfText(picture, row.adjusted(4, 4, -4, -4) & picture.rect());
                box->hidePopup();
                QVERIFY2(found >= kReadable,
                         qPrintable(QStringLiteral("%1: %2").arg(box->accessibleName()).arg(found)));
            }
        }
    }
    void theNamesOfStagesCanBeReadOnBothSidesOfTheHandle()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:teapot"));
        auto* track = desk.window.dock("timeline")->findChild<StepTrack*>();
        for (const char* look : {"light", "dark"}) {
            wear(desk, look);
            for (const std::int64_t step : {std::int64_t{10}, std::int64_t{-1}}) {
                QVERIFY(desk.goTo(Grain::Line, step));
                const auto& stages = track->marks().stages;
                const auto  raster = std::ranges::find(stages, nameOf(Stage::Raster), &TrackMarks::Named::name);
                QVERIFY(raster != stages.end());
                const double from = track->placeOf(raster->step),
                             to   = raster + 1 == stages.end() ? track->width() : track->placeOf((raster + 1)->step);
                const QRect name =
                    QRect(0, 0, 60, 14).translated(static_cast<int>((from + to) / 2) - 30, track->height() / 2 - 7);
                const double found = contrastOfText(track->grab().toImage(), name);
                QVERIFY2(found >= kReadable,
                         qPrintable(QStringLiteral("%1, step %2: %3").arg(look).arg(step).arg(found)));
            }
        }
    }
    void thePickedPixelStandsOutInTheMagnifier()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:teapot"));
        desk.session.pick(QPoint(160, 90));
        auto* magnifier = desk.window.findChild<Magnifier*>();
        for (const char* look : {"light", "dark"}) {
            wear(desk, look);
            QVERIFY(magnifier->isVisible());
            const QRect  lens = QRect(0, 0, 150, 150).translated(kStep, kStep);
            const double found =
                contrastIn(magnifier->grab().toImage(), QRect(0, 0, 16, 16).translated(lens.center() - QPoint(8, 8)));
            QVERIFY2(found >= kSeen, qPrintable(QStringLiteral("%1: %2").arg(look).arg(found)));
        }
    }
    void theButtonsOfQtsFileDialogShowTheirIcons()
    {
        Desk desk;
        for (const char* look : {"light", "dark"}) {
            wear(desk, look);
            QFileDialog dialog(&desk.window);
            dialog.setOption(QFileDialog::DontUseNativeDialog);
            dialog.show();
            for (const char* name : {"backButton", "forwardButton", "toParentButton", "newFolderButton",
                                     "listModeButton", "detailModeButton"}) {
                auto*        button = dialog.findChild<QToolButton*>(name);
                const QImage inside = button->grab(button->rect().adjusted(3, 3, -3, -3)).toImage();
                QRect        ink;
                for (int y = 0; y < inside.height(); ++y)
                    for (int x = 0; x < inside.width(); ++x)
                        if (inside.pixel(x, y) != inside.pixel(0, 0)) ink |= QRect(x, y, 1, 1);
                QVERIFY2(
                    ink.width() >= 8 && ink.height() >= 8,
                    qPrintable(QStringLiteral("%1, %2: %3 x %4").arg(look, name).arg(ink.width()).arg(ink.height())));
            }
        }
    }
    void theMagnifierGivesWayToTheMouseAndLeavesTheChipsUncovered()
    {
        Desk desk;
        QVERIFY(desk.open("builtin:teapot"));
        FrameView& view = desk.window.view();
        desk.session.pick(QPoint(160, 90));
        auto* magnifier = desk.window.findChild<Magnifier*>();
        view.setAttribute(Qt::WA_UnderMouse);
        const QPoint before = magnifier->pos();
        QTest::mouseMove(&view, magnifier->geometry().center());
        QTest::qWait(10);
        QVERIFY(magnifier->pos() != before);
        QVERIFY(magnifier->y() >= 5 * kStep);  // the chips are above
    }
    void theCountAboveABarIsWhole()
    {
        DepthChart chart;
        chart.resize(300, chart.sizeHint().height());
        chart.present({{1000, 1, 1, 1, 1, 1}, {1, 0, 0, 0, 0, 0}});  // by NodeVerdict: five slivers on a high bar
        const QImage picture = chart.grab().toImage();
        for (int x = 0; x < picture.width(); ++x) QCOMPARE(picture.pixelColor(x, 0), picture.pixelColor(0, 0));
    }
    void oneIsNoPlural()
    {
        Desk          desk;
        const QString path  = desk.folder.filePath("one.obj");
        const auto    write = [&](const char* text) {
            QFile file(path);
            return file.open(QIODevice::WriteOnly) && file.write(text) > 0;
        };
        QVERIFY(write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        QVERIFY(desk.open(path));
        QStringList said;
        for (const auto* label : desk.window.findChildren<QLabel*>()) said << label->text();
        QVERIFY(said.join('\n').contains("one.obj \u2014 1 triangle"));
        QVERIFY(said.join('\n').contains("1 of 1 triangle seen in "));
        QVERIFY(write("v 0 0 0\n"));
        desk.window.open(path);
        QVERIFY(desk.settles());
        said << desk.window.messages().sentence();
        QVERIFY2(said.back().contains("1 vertex but no faces"), qPrintable(said.back()));
        for (const QString& text : said)
            QVERIFY2(!text.contains(QRegularExpression("(^|[^0-9,.])1 (triangles|vertices|pixels|faces)")),
                     qPrintable(text));
    }
};

ZSCOPE_UI_TEST(LooksTest, "looks_test", Window)
#include "looks_test.moc"
