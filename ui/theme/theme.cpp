// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/theme.h"

#include <QApplication>

namespace zscope::ui {
namespace {

const Theme& lightTheme()
{
    static const Theme theme{
        .dark       = false,
        .ground     = QColor(0xEEF0F3),
        .card       = QColor(0xFFFFFF),
        .canvas     = QColor(0xF4F6F8),
        .border     = QColor(0xDCE0E5),
        .text       = QColor(0x1B2026),
        .softText   = QColor(0x5F6B78),
        .button     = QColor(0x1B2026),
        .buttonText = QColor(0xFFFFFF),
        .now        = QColor(0xE69F00),
        .nowTint    = QColor(0xFFF1CF),
        .entered    = QColor(0x009E73),
        .left       = QColor(0xD55E00),
        .picked     = QColor(0x0072B2),
        .pickedTint = QColor(0xDCEBF7),
        .idle       = QColor(0x56B4E9),
        .idleText   = QColor(0x1B2026),
        .hidden     = QColor(0xB6578F),
        .outside    = QColor(0x7C8794),
        .error      = QColor(0xB00020),
        .errorTint  = QColor(0xFDECEE),
        .polygons   = {QColor(0x56B4E9), QColor(0x0072B2), QColor(0x8FCBB9), QColor(0xA7B4C2), QColor(0xCC9FBA)},
    };
    return theme;
}

const Theme& darkTheme()
{
    static const Theme theme{
        .dark       = true,
        .ground     = QColor(0x16191D),
        .card       = QColor(0x20242A),
        .canvas     = QColor(0x1A1D22),
        .border     = QColor(0x363C45),
        .text       = QColor(0xE8ECF1),
        .softText   = QColor(0x9AA6B4),
        .button     = QColor(0xE8ECF1),
        .buttonText = QColor(0x16191D),
        .now        = QColor(0xF0AE1E),
        .nowTint    = QColor(0x4A3A12),
        .entered    = QColor(0x2BC596),
        .left       = QColor(0xF0803A),
        .picked     = QColor(0x6CB8EE),
        .pickedTint = QColor(0x213A50),
        .idle       = QColor(0x56B4E9),
        .idleText   = QColor(0x16191D),
        .hidden     = QColor(0xE096C0),
        .outside    = QColor(0x8B97A5),
        .error      = QColor(0xFF6B7D),
        .errorTint  = QColor(0x44212A),
        .polygons   = {QColor(0x4A9CCB), QColor(0x1C78B4), QColor(0x5FA38F), QColor(0x76828F), QColor(0xA87F98)},
    };
    return theme;
}

}  // namespace

const Theme& themeOf(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness() < 128 ? darkTheme() : lightTheme();
}

QPalette paletteOf(Appearance appearance, const QPalette& system)
{
    const bool   dark  = appearance == Appearance::Dark || (appearance == Appearance::System && themeOf(system).dark);
    const Theme& theme = dark ? darkTheme() : lightTheme();

    QPalette palette;
    palette.setColor(QPalette::Window, theme.ground);
    palette.setColor(QPalette::WindowText, theme.text);
    palette.setColor(QPalette::Base, theme.card);
    palette.setColor(QPalette::AlternateBase, theme.canvas);
    palette.setColor(QPalette::Text, theme.text);
    palette.setColor(QPalette::Button, theme.card);
    palette.setColor(QPalette::ButtonText, theme.text);
    palette.setColor(QPalette::BrightText, theme.error);
    palette.setColor(QPalette::ToolTipBase, theme.card);
    palette.setColor(QPalette::ToolTipText, theme.text);
    palette.setColor(QPalette::PlaceholderText, theme.softText);
    palette.setColor(QPalette::Highlight, theme.picked);
    palette.setColor(QPalette::HighlightedText, theme.dark ? theme.ground : theme.card);
    palette.setColor(QPalette::Link, theme.picked);
    palette.setColor(QPalette::Mid, theme.border);
    palette.setColor(QPalette::Midlight, theme.border);
    palette.setColor(QPalette::Light, theme.card);
    palette.setColor(QPalette::Dark, theme.border);
    palette.setColor(QPalette::Shadow, theme.border);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, theme.dark ? QColor(0x66707C) : QColor(0xA3ACB6));
    return palette;
}

QString styleSheetOf(const Theme& theme)
{
    QString                               sheet   = QStringLiteral(R"(
        QMainWindow, QDialog { background: @ground; }
        QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
        QMainWindow::separator { background: transparent; width: 8px; height: 8px; }
        QMenuBar { background: @card; padding: 4px 8px; border-bottom: 1px solid @border; }
        QMenuBar::item { padding: 4px 8px; border-radius: 4px; background: transparent; }
        QMenuBar::item:selected { background: @ground; }
        QMenu { background: @card; border: 1px solid @border; padding: 4px; }
        QMenu::item { padding: 5px 24px 5px 28px; border-radius: 4px; }
        QMenu::item:selected { background: @pickedTint; color: @text; }
        QMenu::item:disabled { color: @softText; }
        QMenu::separator { height: 1px; background: @border; margin: 4px 8px; }
        QMenu::icon { padding-left: 6px; }
        QMenu::indicator { width: 14px; height: 14px; margin-left: 6px; }
        QToolBar { background: @card; border: none; border-bottom: 1px solid @border; padding: 6px 8px; spacing: 8px;
                   margin-bottom: 8px; }
        QToolBar::separator { width: 1px; background: @border; margin: 4px 4px; }
        QToolButton, QPushButton { background: @card; color: @text; border: 1px solid @border; border-radius: 5px;
                                   padding: 5px 12px; }
        QToolButton:hover, QPushButton:hover { background: @ground; }
        QToolButton:focus, QPushButton:focus { border-color: @picked; }
        QToolButton:checked, QPushButton:checked, QPushButton#strong { background: @button; color: @buttonText;
                                                                      border-color: @button; }
        QToolButton:disabled, QPushButton:disabled { color: @faint; }
        QPushButton#strong:disabled { background: @ground; border-color: @border; color: @faint; }
        QToolButton::menu-indicator { image: none; }
        QFileDialog QToolButton, QTabBar QToolButton, QToolButton#qt_toolbar_ext_button { padding: 2px; }
        QToolButton#plain { border: none; padding: 2px; background: transparent; }
        QToolButton#plain:hover { background: @ground; }
        QComboBox, QSpinBox, QDoubleSpinBox, QLineEdit { background: @card; border: 1px solid @border;
              border-radius: 5px; padding: 4px 8px; min-height: 18px; selection-background-color: @picked; }
        QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus, QLineEdit:focus { border-color: @picked; }
        QComboBox:disabled { color: @faint; }
        QComboBox::drop-down { border: none; width: 20px; }
        QComboBox::down-arrow { image: url(:/icons/@arrow.svg); width: 10px; height: 10px; }
        QComboBox, QComboBox QAbstractItemView { selection-background-color: @pickedTint; selection-color: @text; }
        QComboBox QAbstractItemView { background: @card; border: 1px solid @border; padding: 4px; outline: none; }
        QDoubleSpinBox::up-button, QDoubleSpinBox::down-button, QSpinBox::up-button, QSpinBox::down-button { width: 0; }
        QFrame#cardTitle { background: @card; border: 1px solid @border; border-bottom: none;
              border-top-left-radius: 7px; border-top-right-radius: 7px; }
        QFrame#cardBody { background: @card; border: 1px solid @border; border-top: none;
              border-bottom-left-radius: 7px; border-bottom-right-radius: 7px; }
        QFrame#cardWhole { background: @card; border: 1px solid @border; border-radius: 7px; }
        QFrame#picture { background: @canvas; border: 1px solid @border; border-radius: 7px; }
        QLabel#title { font-weight: 600; }
        QLabel#soft, QLabel#hint { color: @softText; }
        QLabel#section { font-weight: 600; }
        QComboBox#compact { padding: 1px 8px; }
        QFrame#messageBar { background: @errorTint; border: 1px solid @error; border-radius: 7px; }
        QFrame#messageBar QLabel { color: @text; }
        QTableView { background: @card; border: none; gridline-color: transparent; outline: none;
              selection-background-color: @pickedTint; selection-color: @text; }
        QHeaderView { background: @card; border: none; }
        QHeaderView::section { background: @card; color: @softText; border: none; border-bottom: 1px solid @border;
              padding: 2px 2px 4px 2px; font-weight: normal; }
        QStatusBar { background: @card; border-top: 1px solid @border; }
        QStatusBar::item { border: none; }
        QStatusBar QLabel { padding: 0 8px; }
        QTabBar { qproperty-drawBase: 0; }
        QTabBar::tab { background: transparent; color: @softText; border: 1px solid transparent; border-radius: 5px;
              padding: 3px 10px; margin: 0 4px 4px 0; }
        QTabBar::tab:selected { background: @card; color: @text; border-color: @border; }
        QTabBar::tab:hover { color: @text; }
        QTabBar::tab:focus { border-color: @picked; }
        QTreeView { background: @card; border: none; outline: none; selection-background-color: @pickedTint;
            selection-color: @text; }
        QTreeView::item { padding: 1px 0; }
        QCheckBox { spacing: 8px; }
        QCheckBox::indicator { width: 14px; height: 14px; border: 1px solid @softText; border-radius: 3px;
            background: @card; }
        QCheckBox::indicator:checked { background: @picked; border-color: @picked; image: url(:/icons/@tick.svg); }
        QCheckBox::indicator:disabled { border-color: @border; }
        QCheckBox:focus { color: @picked; }
        QRadioButton::indicator { width: 10px; height: 10px; border: 2px solid @softText; border-radius: 7px;
            background: @card; }
        QRadioButton::indicator:checked { background: @picked; }
        QRadioButton::indicator:focus { border-color: @picked; }
        QTabBar[atLeftEdge="true"]::tab { margin: 0 0 4px 8px; }
        QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
        QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
        QScrollBar::handle { background: @border; border-radius: 4px; min-height: 24px; min-width: 24px; margin: 1px; }
        QScrollBar::handle:hover { background: @softText; }
        QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
        QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
        QScrollArea { border: none; background: transparent; }
        QScrollArea > QWidget > QWidget { background: transparent; }
        QListWidget { background: transparent; border: none; outline: none; }
        QListWidget#lessons::item { padding: 4px; border-radius: 4px; }
        QListWidget#lessons::item:selected { background: @pickedTint; color: @text; }
        QProgressBar { background: @ground; border: none; border-radius: 3px; max-height: 6px; min-height: 6px; }
        QProgressBar::chunk { background: @idle; border-radius: 3px; }
        QToolTip { background: @card; color: @text; border: 1px solid @border; padding: 4px 8px; }
    )");
    const std::pair<const char*, QString> words[] = {
        {"@ground", theme.ground.name()},
        {"@card", theme.card.name()},
        {"@canvas", theme.canvas.name()},
        {"@border", theme.border.name()},
        {"@buttonText", theme.buttonText.name()},
        {"@button", theme.button.name()},
        {"@softText", theme.softText.name()},
        {"@text", theme.text.name()},
        {"@pickedTint", theme.pickedTint.name()},
        {"@picked", theme.picked.name()},
        {"@errorTint", theme.errorTint.name()},
        {"@error", theme.error.name()},
        {"@idle", theme.idle.name()},
        {"@faint", theme.dark ? "#66707c" : "#a3acb6"},
        {"@tick", theme.dark ? "check-dark" : "check-light"},
        {"@arrow", theme.dark ? "arrow-down-light" : "arrow-down-dark"},
    };
    for (const auto& [word, value] : words) sheet.replace(QLatin1String(word), value);
    return sheet;
}

QFont fontOfHeight(int pixels)
{
    QFont font = QApplication::font();
    font.setPixelSize(pixels);
    return font;
}

}  // namespace zscope::ui
