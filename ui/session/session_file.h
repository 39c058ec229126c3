// SPDX-License-Identifier: GPL-3.0-or-later
// A session as a file: what brings the same view back, with the same step, picks and marks. JSON, so that a teacher can
// read and change it.
//
// Format     {"zscope-session":1, "scene":..., "camera":{the ten numbers}, "cull":"none"|"back", "algorithm":{axis:
//            choice, "fault": "word" or "word+word"}, "grain":word, "step":number|"end", "picked":[x,y], "node":{...},
//            "triangle":n, "level":n, "layer":word, "range":{...}, "over":{...}, "compare":{...}, "trace":path,
//            "bookmarks":[...], "breakpoints":[...], "layout":{...}}; all but the first three may be missing
// Scene      builtin:..., or a path; below the file's own folder it is relative to that, so that both can be moved
// Theirs     "compare" holds an "algorithm", or "files" that another program drew; their paths and that of "trace" are
//            written like the scene's. They are read and judged anew; a file that is missing is named in a sentence
// Errors     Input, "file:line: sentence"
#pragma once

#include <string>

#include <QByteArray>
#include <QStringList>

#include "ui/session/session.h"

namespace zscope::ui {

inline constexpr const char* kSessionSuffix = "zscope-session";

struct WindowLayout {
    QByteArray  geometry, state;  // of the window, as Qt keeps them
    QStringList hidden;           // words of panels that are closed
    QString     name;             // of the layout that it has come from; empty: not known
};

struct SessionFile {
    QString                      scene;  // as Session::open() takes it
    Camera                       camera;
    FaceCulling                  faceCulling = FaceCulling::None;
    Pipeline                     pipeline;
    Grain                        grain = Grain::Frame;
    std::optional<std::uint64_t> step;  // nothing: the finished picture
    Selection                    selection;
    Look                         look;
    Layers                       layers;
    std::optional<Pipeline>      other;   // B, or
    QStringList                  theirs;  // the files that it was read from
    QString                      trace;
    CompareShow                  show      = CompareShow::A;
    Link                         link      = Link::Number;
    bool                         isLinked  = true;
    double                       wipe      = 0.5;
    std::uint32_t                tolerance = 0;
    WindowLayout                 layout;
};

/// Nothing while no scene is open.
std::optional<SessionFile> sessionFileOf(const Session& session);
std::string                sessionToJson(const SessionFile& session, const QString& file);
Result<SessionFile>        sessionFromJson(const std::string& text, const QString& file);

/// Opens it: the scene is loaded like any other, what cannot be loaded leaves everything as it was.
void restore(Session& session, const SessionFile& file);

}  // namespace zscope::ui
