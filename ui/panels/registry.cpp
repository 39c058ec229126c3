// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/registry.h"

#include <array>

#include <QCoreApplication>

#include "ui/panels/active_edges/active_edges_panel.h"
#include "ui/panels/compare/compare_panel.h"
#include "ui/panels/depth_test/depth_test_panel.h"
#include "ui/panels/diagnosis/diagnosis_panel.h"
#include "ui/panels/faults/faults_panel.h"
#include "ui/panels/hierarchy/hierarchy_panel.h"
#include "ui/panels/lessons/lessons_panel.h"
#include "ui/panels/marks/marks_panel.h"
#include "ui/panels/measure/measure_panel.h"
#include "ui/panels/observer/observer_panel.h"
#include "ui/panels/pipeline/pipeline_panel.h"
#include "ui/panels/pyramid/pyramid_panel.h"
#include "ui/panels/scene/scene_panel.h"
#include "ui/panels/timeline/timeline_panel.h"
#include "ui/panels/trace/trace_panel.h"
#include "ui/panels/why/why_panel.h"

namespace zscope::ui {
namespace {

template <class Kind>
Panel* make(Session& session)
{
    return new Kind(session);
}

bool always(const Pipeline&) { return true; }

bool keepsPyramid(const Pipeline& pipeline)
{
    return pipeline.upkeep != Upkeep::None || pipeline.depth == DepthMoment::ZCull;
}

bool visitsTree(const Pipeline& pipeline) { return pipeline.order != Order::Submitted; }

constexpr std::array kPanels{
    PanelEntry{"scene", QT_TRANSLATE_NOOP("Panels", "Scene"), Qt::LeftDockWidgetArea, make<ScenePanel>, always},
    PanelEntry{"pipeline", QT_TRANSLATE_NOOP("Panels", "Pipeline"), Qt::LeftDockWidgetArea, make<PipelinePanel>,
               always},
    PanelEntry{"lessons", QT_TRANSLATE_NOOP("Panels", "Lessons"), Qt::LeftDockWidgetArea, make<LessonsPanel>, always,
               "scene"},
    PanelEntry{"active-edges", QT_TRANSLATE_NOOP("Panels", "Active edges"), Qt::RightDockWidgetArea,
               make<ActiveEdgesPanel>, drawsLineByLine, nullptr, 72},
    PanelEntry{"pyramid", QT_TRANSLATE_NOOP("Panels", "Pyramid"), Qt::RightDockWidgetArea, make<PyramidPanel>,
               keepsPyramid, nullptr, 40},
    PanelEntry{"hierarchy", QT_TRANSLATE_NOOP("Panels", "Hierarchy"), Qt::RightDockWidgetArea, make<HierarchyPanel>,
               visitsTree, nullptr, 32},
    PanelEntry{"observer", QT_TRANSLATE_NOOP("Panels", "Observer"), Qt::RightDockWidgetArea, make<ObserverPanel>,
               visitsTree, "hierarchy", 32},
    PanelEntry{"depth-test", QT_TRANSLATE_NOOP("Panels", "Depth test"), Qt::RightDockWidgetArea, make<DepthTestPanel>,
               always, "hierarchy", 28},
    PanelEntry{"why", QT_TRANSLATE_NOOP("Panels", "Why"), Qt::RightDockWidgetArea, make<WhyPanel>, always, "depth-test",
               28},
    PanelEntry{"compare", QT_TRANSLATE_NOOP("Panels", "Compare"), Qt::RightDockWidgetArea, make<ComparePanel>, always,
               "depth-test", 28},
    PanelEntry{"faults", QT_TRANSLATE_NOOP("Panels", "Faults"), Qt::LeftDockWidgetArea, make<FaultsPanel>, always,
               "pipeline"},
    PanelEntry{"marks", QT_TRANSLATE_NOOP("Panels", "Marks"), Qt::LeftDockWidgetArea, make<MarksPanel>, always,
               "scene"},
    PanelEntry{"diagnosis", QT_TRANSLATE_NOOP("Panels", "Diagnosis"), Qt::LeftDockWidgetArea, make<DiagnosisPanel>,
               always, "scene", 60, false},
    PanelEntry{"trace", QT_TRANSLATE_NOOP("Panels", "Trace"), Qt::LeftDockWidgetArea, make<TracePanel>, always, "scene",
               60, false},
    PanelEntry{"measure", QT_TRANSLATE_NOOP("Panels", "Measure"), Qt::RightDockWidgetArea, make<MeasurePanel>, always,
               nullptr, 60, false},
    PanelEntry{"timeline", QT_TRANSLATE_NOOP("Panels", "Timeline"), Qt::BottomDockWidgetArea, make<TimelinePanel>,
               always},
};

}  // namespace

QString PanelEntry::translatedTitle() const { return QCoreApplication::translate("Panels", title); }

std::span<const PanelEntry> panels() { return kPanels; }

}  // namespace zscope::ui
