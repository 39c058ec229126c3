// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/course.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>

#include "core/lesson/lesson_file.h"
#include "ui/session/session.h"
#include "ui/session/tracer.h"
#include "ui/text/phrase_book.h"

static void registerLessons()  // the macro wants to stand outside any namespace
{
    Q_INIT_RESOURCE(zscope_lessons);
}

namespace zscope::ui {
namespace {

const QString kBundled  = QStringLiteral(":/lessons");
constexpr int kSettleMs = 150;

QString text(const std::string& utf8) { return QString::fromStdString(utf8); }

/// A lesson's name for people and the command line: its file without folder and suffix.
QString nameOf(const QString& file) { return QFileInfo(file).completeBaseName(); }

}  // namespace

Course::Course(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_worker(std::make_unique<Worker>())
{
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettleMs);
    connect(&m_settle, &QTimer::timeout, this, &Course::reload);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_settle, qOverload<>(&QTimer::start));
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, &m_settle, qOverload<>(&QTimer::start));
    connect(&m_session, &Session::changed, this, [this](Changes what) {
        if (what & Change::Scene) {
            m_broken.reset();
            QTimer::singleShot(0, this, &Course::leaveIfElsewhere);  // once the scene has its view
        }
        runWhenThere();
    });
    connect(&m_session, &Session::failed, this, [this] {  // the scene cannot be had: nothing to wait for
        if (m_isComing && !m_isAsked) m_isComing = false;
    });
    registerLessons();
    reload();
}

Course::~Course() = default;

// Lessons -----------------------------------------------------------------------------------------------------------

void Course::setFolder(const QString& folder)
{
    m_folder = folder.isEmpty() ? QString() : QFileInfo(folder).absoluteFilePath();
    reload();
    if (!m_folder.isEmpty() && !QFileInfo(m_folder).isDir())
        emit troubled(
            [folder = m_folder] { return tr("%1 is not a folder of lessons").arg(QDir::toNativeSeparators(folder)); });
    else if (!m_troubles.empty())
        emit troubled([error = m_troubles.front()] { return said(error); });
}

QStringList Course::troubles() const
{
    QStringList sentences;
    for (const Error& error : m_troubles) sentences << said(error);
    return sentences;
}

void Course::readFolder(const QString& folder)
{
    const QDir here(folder);
    for (const QString& name : here.entryList({QStringLiteral("*.md")}, QDir::Files | QDir::Readable, QDir::Name)) {
        if (name.compare(QStringLiteral("README.md"), Qt::CaseInsensitive) == 0) continue;
        const QString  path   = here.filePath(name);
        Result<Lesson> lesson = [&]() -> Result<Lesson> {
            if (!path.startsWith(':')) return readLesson(QDir::toNativeSeparators(path).toStdString());
            QFile file(path);
            if (!file.open(QIODevice::ReadOnly))
                return Error{Trouble::Input, "the lesson cannot be read", path.toStdString()};
            return parseLesson(file.readAll().toStdString(), path.toStdString());
        }();
        if (lesson)
            m_lessons.push_back(*std::move(lesson));
        else
            m_troubles.push_back(lesson.error());
        if (!path.startsWith(':')) m_watcher.addPath(path);
    }
}

void Course::reload()
{
    const std::optional<Answered> before = m_place ? std::optional(keyOf(*m_place)) : std::exchange(m_broken, {});
    if (!m_watcher.files().isEmpty()) m_watcher.removePaths(m_watcher.files());
    if (!m_watcher.directories().isEmpty()) m_watcher.removePaths(m_watcher.directories());
    m_lessons.clear();
    m_troubles.clear();
    m_place.reset();
    m_run.reset();
    ++m_number;
    m_isComing = m_isAsked = false;
    readFolder(kBundled);
    if (!m_folder.isEmpty() && QFileInfo(m_folder).isDir()) {
        readFolder(m_folder);
        m_watcher.addPath(m_folder);
    }
    if (before) {
        for (std::size_t i = 0; i < m_lessons.size(); ++i)
            if (text(m_lessons[i].file) == before->first)
                goTo({i, std::min(before->second, m_lessons[i].pages.size() - 1)});
        if (!m_place
            && std::ranges::any_of(m_troubles, [&](const Error& error) { return text(error.file) == before->first; }))
            m_broken = before;
    }
    emit changed();
}

std::optional<std::size_t> Course::find(const QString& name) const
{
    for (std::size_t i = m_lessons.size(); i-- > 0;)  // a teacher's before one of the program of the same name
        if (const QString file = text(m_lessons[i].file); file == name || nameOf(file) == nameOf(name)) return i;
    bool       isNumber = false;
    const uint number   = name.toUInt(&isNumber);  // as the list counts them
    if (isNumber && number >= 1 && number <= m_lessons.size()) return number - 1;
    return {};
}

// The page ----------------------------------------------------------------------------------------------------------

void Course::open(std::size_t lesson, std::size_t page)
{
    if (lesson >= m_lessons.size()) return;
    goTo({lesson, std::min(page, m_lessons[lesson].pages.size() - 1)});
    emit opened();
}

void Course::close()
{
    const bool comparesAsPage = m_place && m_session.now().compare.other == page()->compared;
    m_place.reset();
    m_broken.reset();
    m_run.reset();
    ++m_number;
    m_isComing = m_isAsked = false;
    m_worker->cancel();
    if (comparesAsPage) takeTheirsBack();  // not over a B that was chosen meanwhile
    m_aside.reset();
    if (const auto size = std::exchange(m_sizeBefore, {}); size && m_session.now().view.width > 0)
        m_session.setPictureSize(size->width(), size->height());
    emit changed();
}

void Course::leaveIfElsewhere()
{
    const auto& scene = m_session.now().scene;
    if (!m_place || !scene || scene->word == text(page()->scene)) return;
    const auto        theirs = m_session.now().compare.theirs;
    const TheirTrace* trace  = m_session.tracer().trace();
    if ((theirs && theirs->sceneWord == scene->word) || (trace && trace->sceneWord == scene->word)) return;
    const ViewRequest &now = m_session.now().view, &ofPage = page()->view;
    // the new one has a size of its own
    if (now.width != ofPage.width || now.height != ofPage.height) m_sizeBefore.reset();
    showList();
}

void Course::showList()
{
    close();
    emit listWanted();
}

void Course::next()
{
    if (m_place && m_place->page + 1 < lesson()->pages.size()) goTo({m_place->lesson, m_place->page + 1});
}

void Course::back()
{
    if (m_place && m_place->page > 0) goTo({m_place->lesson, m_place->page - 1});
}

void Course::goTo(const Place& place)
{
    m_place = place;
    m_broken.reset();
    show();
}

void Course::show()
{
    if (!m_place) return;
    const LessonPage& page = *this->page();
    if (!m_sizeBefore) m_sizeBefore = QSize(m_session.now().view.width, m_session.now().view.height);
    m_run.reset();
    m_isComing = true;
    m_isAsked  = false;
    ++m_number;
    m_session.player().setPlaying(false);
    m_session.setPipeline(page.pipeline);
    m_session.setLayer(*page.layer);
    compareAsPage();
    Layers layers  = m_session.now().layers;
    layers.boxes   = std::ranges::find(page.overlays, "boxes") != page.overlays.end();
    layers.pyramid = std::ranges::find(page.overlays, "pyramid") != page.overlays.end();
    m_session.setLayers(layers);
    const auto& scene = m_session.now().scene;
    if (scene && scene->word == text(page.scene))
        m_session.useView(viewOfPage(page, scene->scene()));
    else
        m_session.open(text(page.scene), [page](const Scene& loaded) { return viewOfPage(page, loaded); });
    emit changed();
    runWhenThere();
}

void Course::compareAsPage()
{
    if (!page()->compared) {
        takeTheirsBack();
        if (!m_session.now().compare.theirs) m_session.compareWith({});
        return;
    }
    if (const auto theirs = m_session.now().compare.theirs) m_aside = theirs;
    m_session.compareWith(page()->compared);
    if (m_aside)
        emit m_session.noticed(tr("This page compares with a B of its own; your picture is B again after it."));
}

void Course::takeTheirsBack()
{
    if (const auto theirs = std::exchange(m_aside, {}); theirs && !m_session.now().compare.theirs)
        m_session.compareWithTheirs(theirs);
}

void Course::runWhenThere()
{
    if (!m_isComing || m_isAsked || !m_place) return;
    const LessonPage& page = *this->page();
    const Snapshot&   now  = m_session.now();
    if (!now.scene || now.scene->word != text(page.scene) || now.pipeline != page.pipeline) return;
    const ViewRequest view   = viewOfPage(page, now.scene->scene());
    const auto        camera = makeCamera(view, now.scene->scene().bounds);
    if (!camera || now.camera != *camera) return;
    m_isAsked = true;
    m_session.setFaceCulling(view.faceCulling.value_or(FaceCulling::None));
    m_worker->post(Worker::Slot::Step, [this, page, file = lesson()->file, request = m_session.request(),
                                        number = m_number](const std::atomic<bool>& cancel) mutable {
        request.cancel = &cancel;
        auto run       = runPage(page, file, request);
        m_worker->deliver([this, run = std::move(run), number] {
            if (number != m_number) return;  // another page by now
            if (run) return arrived(*run);
            m_isComing = false;
            if (run.error().kind != Trouble::Cancelled) emit troubled([error = run.error()] { return said(error); });
            emit changed();
        });
    });
}

void Course::arrived(const PageRun& run)
{
    const LessonPage& page = *this->page();
    m_run                  = run;
    m_isComing             = false;
    if (page.stop.isEnd())
        m_session.goToEnd();
    else
        m_session.goToStepOf(run.grain, run.step.value);
    m_session.pick(page.pick ? std::optional(QPoint(page.pick->x, page.pick->y)) : std::nullopt);
    if (!page.panel.empty()) emit panelWanted(text(page.panel));
    if (m_session.now().compare.theirs && isStale(m_session.now())) {
        m_session.showCompared(CompareShow::A);
        emit m_session.noticed(
            tr("Your picture is of another view than this page. “Back to its view” in the panel "
               "Diagnosis shows it; the page stays open."));
    }
    emit changed();
}

// Answers -----------------------------------------------------------------------------------------------------------

Course::Answered Course::keyOf(const Place& place) const { return {text(m_lessons[place.lesson].file), place.page}; }

const GivenAnswer* Course::given() const
{
    if (!m_place) return nullptr;
    const auto found = m_given.find(keyOf(*m_place));
    return found == m_given.end() ? nullptr : &found->second;
}

void Course::give(const GivenAnswer& answer)
{
    m_given[keyOf(*m_place)] = answer;
    m_first.try_emplace(keyOf(*m_place), answer.isRight);
    emit changed();
}

void Course::answerChoice(std::size_t choice)
{
    if (!right() || !right()->choice || choice >= page()->question->choices.size()) return;
    give({.isRight = *right()->choice == choice, .choice = choice});
}

void Course::answerNumber(const QString& typed)
{
    if (!right() || !right()->number) return;
    bool   isNumber = false;
    double value    = QLocale::c().toDouble(QString(typed).remove(' '), &isNumber);
    if (!isNumber) value = QLocale().toDouble(typed, &isNumber);
    if (isNumber) give({.isRight = right()->accepts(value), .text = typed.trimmed()});
}

void Course::answerPixel(const QPoint& pixel)
{
    if (!right() || right()->pixels.width() == 0) return;
    give({.isRight = right()->acceptsPixel({pixel.x(), pixel.y()}),
          .text    = QStringLiteral("%1, %2").arg(pixel.x()).arg(pixel.y())});
}

Course::Score Course::scoreOf(std::size_t lesson) const
{
    Score score;
    for (std::size_t page = 0; page < m_lessons[lesson].pages.size(); ++page) {
        if (!m_lessons[lesson].pages[page].question) continue;
        ++score.questions;
        const auto first = m_first.find(keyOf({lesson, page}));
        if (first == m_first.end()) continue;
        ++score.answered;
        score.right += first->second;
    }
    return score;
}

}  // namespace zscope::ui
