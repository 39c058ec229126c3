// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is left untranslated: every text of the window, and whatever core can say.
#include <array>
#include <map>
#include <random>
#include <set>

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "core/frame/faults.h"
#include "core/frame/frame_plan.h"
#include "core/lesson/explain.h"
#include "core/lesson/layers.h"
#include "core/lesson/replay.h"
#include "core/scene/load.h"
#include "tests/ui/ui_test.h"
#include "ui/text/language.h"
#include "ui/text/phrase_book.h"

using namespace zscope;
using namespace zscope::ui;

namespace {

struct Entry {
    QString translation;
    bool    isFinished = false;
};
using Texts = std::map<std::pair<QString, QString>, Entry>;  // by context and English text

Texts textsOf(const QString& file)
{
    QFile source(file);
    if (!source.open(QIODevice::ReadOnly)) return {};
    Texts            texts;
    QXmlStreamReader xml(&source);
    QString          context, english;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("name")) context = xml.readElementText();
        if (xml.name() == QLatin1String("source")) english = xml.readElementText();
        if (xml.name() == QLatin1String("translation")) {
            const bool isFinished     = !xml.attributes().hasAttribute("type");
            texts[{context, english}] = {xml.readElementText(), isFinished};
        }
    }
    return texts;
}

const QString kChinese = QStringLiteral(ZSCOPE_SOURCE_DIR "/resources/i18n/zscope_zh_CN.ts");

DrawRequest requestFor(const std::string& word, int width, int height)
{
    Result<Scene> scene = loadScene("builtin:" + word);
    ViewRequest   view  = scene->views.empty() ? ViewRequest{} : scene->views.front().view;
    view.width          = width;
    view.height         = height;
    DrawRequest request;
    request.camera  = *makeCamera(view, scene->bounds);
    request.scene   = std::make_shared<PreparedScene>(std::make_shared<const Scene>(std::move(*scene)));
    request.threads = 1;
    return request;
}

/// Small, and together they bring about what sentences tell of.
std::vector<DrawRequest> fewScenes()
{
    std::vector<DrawRequest> scenes;
    for (const char* word :
         {"cubes", "cutouts", "reliefs", "glass", "hard/D6", "hard/B1", "hard/D9", "hard/A8", "hard/C1", "hard/G2"})
        scenes.push_back(requestFor(word, 32, 24));
    scenes.push_back(scenes.front());
    scenes.back().faceCulling = FaceCulling::Back;
    return scenes;
}

class Missing {
public:
    void ask(std::string_view english)
    {
        const QString text = QString::fromUtf8(english.data(), static_cast<qsizetype>(english.size()));
        ++m_asked;
        if (!text.isEmpty() && m_book.translate("Core", text.toUtf8().constData()).isNull()) m_missing.insert(text);
    }
    bool isNone() const
    {
        for (const QString& text : m_missing) qWarning("not in the phrase book: %s", qPrintable(text));
        return m_missing.empty();
    }
    int asked() const { return m_asked; }

private:
    CoreTranslator    m_book{chinesePhrases()};
    std::set<QString> m_missing;
    int               m_asked = 0;
};

}  // namespace

class PhraseBookTest final : public QObject {
    Q_OBJECT

    Translation m_registersTheBook;

private slots:
    void everyTextOfTheWindowIsTranslatedAndKeepsItsArguments()
    {
        const Texts texts = textsOf(kChinese);
        QVERIFY(texts.size() > 450);
        const QRegularExpression argument("%[0-9]");
        for (const auto& [key, entry] : texts) {
            QVERIFY2(entry.isFinished && !entry.translation.isEmpty(), qPrintable(key.first + ": " + key.second));
            std::set<QString> asked, given;
            for (const auto& match : argument.globalMatch(key.second)) asked.insert(match.captured());
            for (const auto& match : argument.globalMatch(entry.translation)) given.insert(match.captured());
            QVERIFY2(asked == given, qPrintable(key.second));
        }
    }
    void theFileOfTranslationsHoldsEveryTextOfTheSourcesAndNoOther()
    {
        const QTemporaryDir folder;
        const QString       fresh = folder.filePath("fresh.ts");
        QProcess            lupdate;
        lupdate.start(ZSCOPE_LUPDATE,
                      {"-silent", "-no-obsolete", "-I", ZSCOPE_SOURCE_DIR, ZSCOPE_SOURCE_DIR "/ui", "-ts", fresh});
        QVERIFY(lupdate.waitForFinished(300'000));
        QCOMPARE(lupdate.exitCode(), 0);
        // a text in no class's context cannot be found
        QCOMPARE(QString::fromUtf8(lupdate.readAllStandardError()), QString());
        const Texts in = textsOf(fresh), kept = textsOf(kChinese);
        QVERIFY(!in.empty());
        for (const auto& [key, entry] : in)
            QVERIFY2(kept.contains(key), qPrintable("run update_translations for: " + key.first + ": " + key.second));
        for (const auto& [key, entry] : kept)
            QVERIFY2(in.contains(key), qPrintable("said nowhere: " + key.first + ": " + key.second));
    }
    void phrasesAreMadeOfPhrasesAndAreAllOrNothing()
    {
        const CoreTranslator book(chinesePhrases());
        const auto           says = [&](const char* english) { return book.translate("Core", english); };
        QCOMPARE(says("Triangle 1,234 is drawn: it is nearest so far at 5 pixels."),
                 QStringLiteral("三角形 1,234 已绘制：目前它在 5 个像素处最近。"));
        QCOMPARE(says("Line 3 is drawn: no edge enters or leaves. 1 face between 2 active edges gave 1 span."),
                 QStringLiteral("第 3 行已绘制：没有边进入或离开。2 条活动边之间的 1 个面产生了 1 个跨度。"));
        QVERIFY(says("Line 3 is drawn: something new. 1 face between 2 active edges gave 1 span.").isNull());
        QVERIFY(says("No triangle meets it. And nothing else.").isNull());
        QCOMPARE(says("No triangle meets it. No triangle meets it."),
                 QStringLiteral("没有三角形与它相遇。没有三角形与它相遇。"));
        QCOMPARE(says("No triangle meets it. (the interval went to one as a whole.) No triangle meets it."),
                 QStringLiteral("没有三角形与它相遇。（该区间整体归一个多边形。）没有三角形与它相遇。"));
        QVERIFY(book.translate("Other", "order").isNull());
    }
    void everythingThatCanBeChosenHasAName()
    {
        Missing missing;
        for (const Preset& preset : presets()) missing.ask(preset.title);
        for (const AxisEntry& axis : axes()) {
            missing.ask(axis.word);
            missing.ask(axis.title);
            for (const ChoiceEntry& choice : axis.choices) missing.ask(choice.title);
        }
        for (const Layer& layer : layers()) {
            missing.ask(layer.word);
            missing.ask(layer.title);
        }
        for (const SceneEntry& scene : builtinScenes()) missing.ask(scene.title);
        for (const Stage stage : kStages) missing.ask(wordOf(stage));
        QVERIFY(missing.isNone());
    }
    void everyReasonWhyAChoiceDoesNotFitIsTranslated()
    {
        Missing missing;
        for (const Preset& preset : presets())
            for (const AxisEntry& one : axes())
                for (const ChoiceEntry& first : one.choices)
                    for (const AxisEntry& other : axes())
                        for (const ChoiceEntry& second : other.choices) {
                            const auto pipeline =
                                withChoice(*withChoice(preset.pipeline, one.word, first.word), other.word, second.word);
                            if (const auto why = explainInvalid(*pipeline)) missing.ask(*why);
                        }
        QVERIFY(missing.asked() > 1000);
        QVERIFY(missing.isNone());
    }
    void everyReasonOfAStageIsTranslated()
    {
        Missing missing;
        for (DrawRequest& request : fewScenes())
            for (const Preset& preset : presets())
                for (const AxisEntry& axis : axes())
                    for (const ChoiceEntry& choice : axis.choices) {
                        request.pipeline = *withChoice(preset.pipeline, axis.word, choice.word);
                        if (explainInvalid(request.pipeline)) continue;
                        for (const bool shade : {true, false}) {
                            request.shade = shade;
                            for (const Stage stage : kStages) missing.ask(reasonFor(stage, request).why);
                        }
                    }
        QVERIFY(missing.isNone());
    }
    void everySentenceOfAStepIsTranslated()
    {
        Missing      missing;
        std::mt19937 random(7);
        std::size_t  scene = 0;
        for (DrawRequest& request : fewScenes()) {
            ++scene;
            for (std::size_t p = 0; p < presets().size(); ++p) {
                if ((scene + p) % 2 == 0) continue;  // each meets half of the scenes
                const Preset& preset = presets()[p];
                request.pipeline     = preset.pipeline;
                Replay replay(request);
                for (const Grain grain : grainsOf(preset.pipeline)) {
                    const auto count = replay.count(grain);
                    QVERIFY(count.ok());
                    for (int i = 0; i < 6; ++i) {
                        const std::uint64_t at = i == 0 ? 0 : i == 1 ? *count - 1 : random() % *count;
                        if (at >= *count) continue;
                        const auto state = replay.at(grain, StepIndex{at});
                        QVERIFY(state.ok());
                        missing.ask(state->sentence);
                    }
                }
            }
        }
        QVERIFY(missing.isNone());
    }
    void everyExplanationIsTranslated()
    {
        Missing      missing;
        std::mt19937 random(11);
        for (DrawRequest& request : fewScenes())
            for (const Preset& preset : presets()) {
                request.pipeline    = preset.pipeline;
                request.faceCulling = random() % 2 ? FaceCulling::Back : FaceCulling::None;
                std::vector<PixelPosition> pixels;
                for (int i = 0; i < 40; ++i)
                    pixels.push_back({static_cast<int>(random() % 4096) % request.camera.width,
                                      static_cast<int>(random() % 4096) % request.camera.height});
                const auto answers = explainPixels(request, pixels);
                QVERIFY2(answers.ok(), answers.ok() ? "" : answers.error().text().c_str());
                for (const PixelExplanation& answer : *answers) {
                    missing.ask(answer.sentence);
                    for (const PixelCandidate& candidate : answer.candidates) {
                        missing.ask(candidate.sentence);
                        for (const Event& event : candidate.events) missing.ask(event.sentence);
                    }
                }
                const auto triangles = request.scene->scene().triangleCount();
                for (int i = 0; i < 4; ++i) {
                    const auto answer =
                        explainTriangle(request, TriangleId{static_cast<std::uint32_t>(random() % triangles)});
                    QVERIFY2(answer.ok(), answer.ok() ? "" : answer.error().text().c_str());
                    missing.ask(answer->sentence);
                    for (const Event& event : answer->events) missing.ask(event.sentence);
                }
            }
        QVERIFY(missing.isNone());
    }
    void everySentenceOfAFaultOrAnotherChoiceIsTranslated()
    {
        std::vector<Pipeline> pipelines;
        Missing               missing;
        for (const FaultEntry& fault : faults()) {
            for (const std::string_view text : {fault.title, fault.cause, fault.cure}) missing.ask(text);
            pipelines.push_back(findPreset(fault.preset)->pipeline);
            pipelines.back().fault = fault.fault;
        }
        for (const char* preset : {"hzb-octree", "interval", "edge-walk"})
            for (const AxisEntry& axis : axes())
                for (const ChoiceEntry& choice : axis.choices)
                    if (const auto pipeline = withChoice(findPreset(preset)->pipeline, axis.word, choice.word);
                        !explainInvalid(*pipeline))
                        pipelines.push_back(*pipeline);
        std::mt19937 random(13);
        std::array requests{requestFor("cubes", 32, 24), requestFor("cutouts", 32, 24), requestFor("hard/D6", 32, 24)};
        for (std::size_t i = 0; i < pipelines.size(); ++i) {
            const Pipeline& pipeline = pipelines[i];
            DrawRequest&    request  = requests[i % requests.size()];
            request.pipeline         = pipeline;
            Replay replay(request);
            for (const Grain grain : grainsOf(pipeline)) {
                const auto count = replay.count(grain);
                QVERIFY(count.ok());
                const auto state = replay.at(grain, StepIndex{random() % *count});
                QVERIFY(state.ok());
                missing.ask(state->sentence);
            }
            std::vector<PixelPosition> pixels;
            for (int n = 0; n < 8; ++n)
                pixels.push_back({static_cast<int>(random() % 32), static_cast<int>(random() % 24)});
            const auto answers = explainPixels(request, pixels);
            QVERIFY(answers.ok());
            for (const PixelExplanation& answer : *answers) {
                missing.ask(answer.sentence);
                for (const PixelCandidate& candidate : answer.candidates) {
                    missing.ask(candidate.sentence);
                    for (const Event& event : candidate.events) missing.ask(event.sentence);
                }
            }
        }
        QVERIFY(missing.isNone());
    }
};

ZSCOPE_UI_TEST(PhraseBookTest, "phrase_book_test", Events)
#include "phrase_book_test.moc"
