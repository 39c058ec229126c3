// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/measure/runs_record.h"

#include "core/scene/view_json.h"

namespace zscope::ui {

Record recordOf(const Session& session, const MeasuredView& view, const std::vector<BenchRow>& rows)
{
    Experiment experiment;
    experiment.title  = {"Runs of one view", "同一视图的运行"};
    experiment.digest = digestOfText(view.digest + cameraToJson(view.camera));
    ExperimentPart part;
    part.scenes.resize(1);
    experiment.parts.push_back(part);
    const LoadedScene& scene = *session.now().scene;
    Record             record{recordHeadFor(experiment), {}};
    record.add({.part        = experiment.title,
                .x           = {},
                .scene       = scene.title.toStdString(),
                .sceneDigest = view.digest,
                .place       = 1,
                .width       = view.camera.width,
                .height      = view.camera.height,
                .word        = scene.word.toStdString(),
                .camera      = view.camera,
                .faceCulling = view.faceCulling,
                .rows        = benchToJson(rows)});
    return record;
}

}  // namespace zscope::ui
