// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheet/sheet_maker.h"

#include <algorithm>

#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/measure/approximate_switches.h"
#include "core/measure/compare.h"
#include "ui/parts/scrolling.h"
#include "ui/session/reproduce.h"
#include "ui/sheet/sheet_writer.h"
#include "ui/text/phrase_book.h"

namespace zscope::ui {
namespace {

constexpr std::size_t kMostColumns = 12;

/// "zscope-cli compare SCENE view --algorithms A,B": the command of the picture with another word at its head and end.
std::string commandFor(const Snapshot& shown, const DrawSettings& settings,
                       const std::vector<BenchAlgorithm>& algorithms)
{
    Snapshot plain    = shown;
    plain.pipeline    = Pipeline{};  // zbuffer: its options are dropped below
    plain.step        = {};
    QStringList words = commandOf(plain, settings);
    if (words.size() > 1) words[1] = QStringLiteral("compare");
    for (qsizetype i = words.size() - 2; i > 1; --i)
        if (words[i] == QStringLiteral("--algorithm") || words[i] == QStringLiteral("--set")
            || words[i] == QStringLiteral("--show"))
            words.remove(i, 2);
    QStringList names;
    for (const BenchAlgorithm& each : algorithms) names << QString::fromStdString(each.name);
    words << QStringLiteral("--algorithms") << names.join(',');
    QString line = commandLineOf(words);
    if (shown.view.exact) line += QStringLiteral("  # %1 is in this file").arg(QLatin1String(kCameraFile));
    return line.toStdString();
}

}  // namespace

SheetMaker::SheetMaker(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_worker(std::make_unique<Worker>())
{}

SheetMaker::~SheetMaker() = default;

std::vector<BenchAlgorithm> SheetMaker::choices(const Session& session, std::size_t& likely)
{
    std::vector<BenchAlgorithm> all;
    const auto                  add = [&all](const Pipeline& pipeline) {
        if (std::ranges::find(all, pipeline, &BenchAlgorithm::pipeline) == all.end())
            all.push_back({zscope::nameOf(pipeline), pipeline, claimOf(pipeline)});
    };
    add(session.now().pipeline);
    if (session.now().compare.other) add(*session.now().compare.other);
    likely = all.size();
    for (const BenchAlgorithm& preset : presetsToTime()) add(preset.pipeline);
    return all;
}

std::vector<BenchAlgorithm> SheetMaker::ask(QWidget* parent, const Session& session)
{
    std::size_t                       likely = 0;
    const std::vector<BenchAlgorithm> all    = choices(session, likely);
    QDialog                           dialog(parent);
    dialog.setWindowTitle(tr("Comparison sheet"));
    auto* about = new QLabel(tr("Which algorithms stand side by side? The first is what the others are held against."));
    about->setWordWrap(true);
    auto* list = new ScrolledPart;
    list->setAccessibleName(tr("Algorithms of the sheet"));
    auto* rows = new QVBoxLayout(list);
    rows->setContentsMargins(0, 0, 0, 0);
    std::vector<QCheckBox*> boxes;
    for (std::size_t i = 0; i < all.size(); ++i) {
        boxes.push_back(new QCheckBox(QString::fromStdString(all[i].name)));
        boxes.back()->setChecked(i < std::max<std::size_t>(likely, 2));
        rows->addWidget(boxes.back());
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    auto* layout  = new QVBoxLayout(&dialog);
    layout->addWidget(about);
    layout->addWidget(scrolling(list), 1);
    layout->addWidget(buttons);
    const auto chosen = [&] {
        std::vector<BenchAlgorithm> picked;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (boxes[i]->isChecked()) picked.push_back(all[i]);
        return picked;
    };
    const auto check = [&] {
        const std::size_t count = chosen().size();
        QPushButton*      ok    = buttons->button(QDialogButtonBox::Ok);
        ok->setEnabled(count >= 2 && count <= kMostColumns);
        ok->setToolTip(ok->isEnabled() ? QString() : tr("A sheet has 2 to %1 columns").arg(kMostColumns));
    };
    for (QCheckBox* box : boxes) connect(box, &QCheckBox::toggled, &dialog, check);
    connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    check();
    dialog.resize(360, 560);
    return dialog.exec() == QDialog::Accepted ? chosen() : std::vector<BenchAlgorithm>();
}

void SheetMaker::make(const std::vector<BenchAlgorithm>& algorithms, const QString& file)
{
    const Snapshot& now = m_session.now();
    if (!now.scene || algorithms.size() < 2) return;
    const std::string command = commandFor(now, m_session.settings(), algorithms);
    CompareRequest    request{.scene       = now.scene->prepared,
                              .camera      = now.camera,
                              .faceCulling = m_session.settings().faceCulling,
                              .algorithms  = algorithms,
                              .threads     = m_session.settings().threads,
                              .simd        = m_session.settings().simd,
                              .memoryLimit = m_session.settings().memoryLimit};
    m_worker->post(Worker::Slot::Draw, [this, request = std::move(request), command, file,
                                        exact = now.view.exact](const std::atomic<bool>& cancel) mutable {
        request.progress.cancel = &cancel;
        auto made               = compareAlgorithms(request);
        if (!made && made.error().kind == Trouble::Cancelled) return;
        auto whole = std::make_shared<Result<zscope::Comparison>>(std::move(made));
        m_worker->deliver([this, whole, request, command, file, exact] {
            if (!*whole) return emit failed(said((*whole).error()));
            const Scene& scene = request.scene->scene();
            if (const auto trouble =
                    writeSheet(file, **whole, scene, sheetWordsOf(**whole, scene, request.camera, command), exact))
                return emit failed(*trouble);
            emit this->made(file);
        });
    });
}

}  // namespace zscope::ui
