// SPDX-License-Identifier: GPL-3.0-or-later
// The lessons: those of the program and those of a teacher's folder, the page that is shown, and what was answered. It
// brings the session to the page's step and asks core what the right answer is there. No widgets.
//
// Theirs     what another program drew stays B where a page compares with nothing. A page that compares sets it aside;
//            it is back with the next page, or when the lesson is closed. Going back to its scene leaves no lesson
// Files      docs/lessons.md; a file that is broken is told of with file and line, the others are there. The folder is
//            watched: a lesson that is saved appears, and the page on show is shown again,
//            also after its file was broken for a while
// Threads    to be used from one thread; the page's run happens on a worker of its own, and the newest page wins
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include "core/lesson/lesson.h"
#include "core/lesson/lesson_run.h"
#include "ui/session/snapshot.h"
#include "ui/session/worker.h"

namespace zscope::ui {

class Session;

/// An answer that was given to a page's question.
struct GivenAnswer {
    bool                       isRight = false;
    std::optional<std::size_t> choice  = {};
    QString                    text    = {};  // a number as it was typed; a pixel
};

class Course final : public QObject {
    Q_OBJECT

public:
    explicit Course(Session& session, QObject* parent = nullptr);
    ~Course() override;

    // Lessons
    /// A teacher's lessons, after those of the program; empty: none.
    void           setFolder(const QString& folder);
    const QString& folder() const { return m_folder; }
    /// Reads all files again.
    void                       reload();
    const std::vector<Lesson>& lessons() const { return m_lessons; }
    /// "file:line: sentence" of each file that could not be read.
    QStringList troubles() const;
    /// The place of a lesson by the name of its file, with or without folder and suffix; nothing: there is none.
    std::optional<std::size_t> find(const QString& name) const;

    // The page
    void open(std::size_t lesson, std::size_t page = 0);
    void close();
    /// Closes the page, and wants the list to be seen and to have the focus.
    void showList();
    void next();
    void back();
    /// Brings the window to the page's scene and step again, after the student has been elsewhere.
    void              show();
    const Lesson*     lesson() const { return m_place ? &m_lessons[m_place->lesson] : nullptr; }
    const LessonPage* page() const { return m_place ? &lesson()->pages[m_place->page] : nullptr; }
    std::size_t       lessonNumber() const { return m_place ? m_place->lesson : 0; }
    std::size_t       pageNumber() const { return m_place ? m_place->page : 0; }
    /// The session stands at the page's step, and the answer is known.
    bool isReady() const { return m_run.has_value(); }
    /// Nothing is on its way.
    bool isSettled() const { return !m_isComing; }

    // Answers
    void answerChoice(std::size_t choice);
    void answerNumber(const QString& typed);
    void answerPixel(const QPoint& pixel);
    /// To the page's question; nothing while it has not been answered.
    const GivenAnswer*  given() const;
    const LessonAnswer* right() const { return m_run && m_run->answer ? &*m_run->answer : nullptr; }
    struct Score {
        int right = 0, answered = 0, questions = 0;  // of first answers
    };
    Score scoreOf(std::size_t lesson) const;

signals:
    /// Another list, page, readiness or answer.
    void changed();
    /// A lesson was opened from the list, or from the command line.
    void opened();
    void panelWanted(const QString& word);
    /// The list of lessons is to be seen, and to have the focus.
    void listWanted();
    /// The sentence in the language of the moment.
    void troubled(const std::function<QString()>& say);

private:
    struct Place {
        std::size_t lesson, page;
        friend auto operator<=>(const Place&, const Place&) = default;
    };
    using Answered = std::pair<QString, std::size_t>;  // file of the lesson, page

    void     readFolder(const QString& folder);
    void     goTo(const Place& place);
    void     runWhenThere();
    void     compareAsPage();
    void     takeTheirsBack();
    void     leaveIfElsewhere();  // once another scene than the page's is shown
    void     arrived(const PageRun& run);
    void     give(const GivenAnswer& answer);
    Answered keyOf(const Place& place) const;

    Session&                m_session;
    QString                 m_folder;
    std::vector<Lesson>     m_lessons;
    std::vector<Error>      m_troubles;
    std::optional<Place>    m_place;
    std::optional<Answered> m_broken;        // the page that was on show when its file broke, for when that is mended
    std::optional<PageRun>  m_run;           // of m_place
    std::uint64_t           m_number   = 0;  // of the page that was asked for last
    bool                    m_isComing = false;  // the session is on its way there, or the answer is
    bool                    m_isAsked  = false;  // the worker is at it
    std::optional<QSize>    m_sizeBefore;        // of the picture, which the lesson's pages change
    // B that another program drew, while a page compares with B of its own
    std::shared_ptr<const TheirPicture> m_aside;
    std::map<Answered, GivenAnswer>     m_given;  // the latest
    std::map<Answered, bool>            m_first;  // whether the first was right
    QFileSystemWatcher                  m_watcher;
    QTimer                              m_settle;  // editors write a file in several goes
    std::unique_ptr<Worker>             m_worker;  // last: stops before anything else goes
};

}  // namespace zscope::ui
