// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report.h"

#include <algorithm>
#include <filesystem>

#include <QBuffer>
#include <QCoreApplication>

#include "core/io/file_writer.h"
#include "core/io/read_file.h"
#include "core/measure/record.h"
#include "ui/report/report_charts.h"
#include "ui/report/report_words.h"
#include "ui/text/language.h"
#include "ui/text/numbers.h"

namespace zscope::ui {
namespace {

QString shown(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

QByteArray pngOf(const QImage& image)
{
    QByteArray bytes;
    QBuffer    buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

/// Everything of one record, read once and written in every language.
class PageWriter {
public:
    PageWriter(const Record& record, std::string folder) : m_record(record), m_folder(std::move(folder)) {}

    Result<Done> read()
    {
        for (const RecordCase& each : m_record.cases) {
            auto rows = rowsOf(each);
            if (!rows) return rows.error();
            if (m_parts.empty() || !(m_parts.back().title == each.part)) m_parts.push_back({each.part, each.x, {}});
            m_parts.back().cases.push_back({QString::fromStdString(each.scene), each.place, *std::move(rows)});
        }
        return Done{};
    }

    Result<Done> write()
    {
        QString     body;
        Translation translation;
        for (const Language language : {Language::English, Language::Chinese}) {
            translation.speak(language);
            const auto section = sectionOf(language);
            if (!section) return section.error();
            body += *section;
        }
        return writeFile(m_folder + "/index.html", page(body).toUtf8().toStdString());
    }

private:
    struct Part {
        ExperimentText          title, x;
        std::vector<ReportCase> cases;
    };

    static const std::string& in(Language language, const ExperimentText& text)
    {
        return language == Language::Chinese ? text.chinese : text.english;
    }

    /// Two radio buttons choose the language without a script: the page is one file that runs nothing.
    QString page(const QString& body) const
    {
        return QStringLiteral(R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>%1</title><style>
body{font:15px/1.5 system-ui,"WenQuanYi Micro Hei",sans-serif;color:#1b1b1f;background:#fff;max-width:1000px;margin:24px auto;padding:0 16px}
h1{font-size:26px;margin:16px 0 4px}h2{font-size:20px;margin:40px 0 8px;border-top:1px solid #ddd;padding-top:24px}
    h3{font-size:16px;margin:24px 0 8px}
p.soft,td.soft{color:#5a5a62}img{max-width:100%;height:auto;display:block}div.wide{overflow-x:auto}
table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:13px;margin:8px 0}
th,td{padding:3px 8px;text-align:right;border-bottom:1px solid #e6e6ea;white-space:nowrap}th.l,td.l{text-align:left}
s{color:#b00020}code{background:#f3f3f6;padding:2px 4px}
section{display:none}#en:checked~section.en,#zh:checked~section.zh{display:block}
h2,h3{break-after:avoid}img,tr{break-inside:avoid}
@media print{input,label{display:none}body{max-width:none;margin:0}div.wide{overflow:visible}table{font-size:8px}
    th,td{padding:2px 3px}td.l{white-space:normal}}
</style></head><body>
<input type="radio" name="language" id="en" checked><label for="en" lang="en">English</label>
<input type="radio" name="language" id="zh"><label for="zh" lang="zh-CN">简体中文</label>
%2</body></html>
)")
            .arg(shown(m_record.head.title.english), body);
    }

    Result<QString> sectionOf(Language language)
    {
        const RecordHead& head = m_record.head;
        const QString     word = language == Language::Chinese ? QStringLiteral("zh") : QStringLiteral("en");
        QString html = QStringLiteral("<section class=\"%1\" lang=\"%1\"><h1>%2</h1><p>%3</p><p class=\"soft\">%4</p>")
                           .arg(word, shown(in(language, head.title)), shown(in(language, head.question)),
                                Report::tr("%1, %2 cores. ZScope %3, compiler %4. %5 of %6 cases. Experiment %7.")
                                    .arg(shown(head.processor), QString::number(head.cores), shown(head.version),
                                         shown(head.compiler), QString::number(m_record.cases.size()),
                                         QString::number(head.caseCount), shown(head.digest)));
        html += QStringLiteral("<p class=\"soft\">%1</p>")
                    .arg(Report::tr("Every picture was compared with the brute-force reference before it was timed. "
                                    "Times are medians; ratios are medians over rounds in which the "
                                    "algorithms were timed in turn, with the interval that holds the true ratio in 19 "
                                    "of 20 experiments as far as the rounds allow. "
                                    "The time of a wrong picture is struck out."));
        for (std::size_t i = 0; i < m_parts.size(); ++i) {
            const Part& part = m_parts[i];
            html += QStringLiteral("<h2>%1</h2>").arg(shown(in(language, part.title)));
            for (const ReportChart& chart :
                 chartsOf(part.cases, QString::fromStdString(in(language, part.x)), head.baseline)) {
                const QByteArray png = pngOf(chart.image);
                const QString    file =
                    QStringLiteral("%1-%2%3.png")
                        .arg(i + 1)
                        .arg(chart.name, language == Language::Chinese ? QStringLiteral("-zh_CN") : QString());
                if (const auto done = writeFile(m_folder + "/" + file.toStdString(),
                                                std::string_view(png.data(), static_cast<std::size_t>(png.size())));
                    !done)
                    return done.error();
                html += QStringLiteral("<h3>%1</h3><img alt=\"%1\" width=\"900\" src=\"data:image/png;base64,%2\">")
                            .arg(chart.title.toHtmlEscaped(), QString::fromLatin1(png.toBase64()));
            }
            html += tableOf(part);
        }
        return html + QStringLiteral("</section>\n");
    }

    QString tableOf(const Part& part) const
    {
        const QString baseline = shown(m_record.head.baseline);
        QString       html =
            QStringLiteral(
                "<div class=\"wide\"><table><tr><th class=\"l\">%1</th><th class=\"l\">%2</th><th>%3</th><th "
                "class=\"l\">%7</th><th>%4</th><th>%5</th><th>%6</th>")
                .arg(Report::tr("scene"), Report::tr("algorithm"), Report::tr("threads"), Report::tr("wrong pixels"),
                     Report::tr("median ms"), Report::tr("best, quartiles"), Report::tr("drawn"));
        if (!baseline.isEmpty())
            html += QStringLiteral("<th>/ %1</th><th>%2</th>").arg(baseline, Report::tr("interval"));
        std::vector<Stage> stages;
        for (const Stage stage : kStages)
            for (const ReportCase& each : part.cases)
                if (std::ranges::find(stages, stage) == stages.end()
                    && std::ranges::any_of(each.rows, [stage](const BenchRow& row) { return msOf(row, stage) > 0; }))
                    stages.push_back(stage);
        for (const Stage stage : stages) html += QStringLiteral("<th>%1</th>").arg(shown(std::string(wordOf(stage))));
        html += QStringLiteral("</tr>");
        for (const ReportCase& each : part.cases)
            for (const BenchRow& row : each.rows) html += rowOf(each, row, stages);
        html += QStringLiteral("</table></div>");
        const bool moves = std::ranges::any_of(part.cases, [](const ReportCase& each) {
            return std::ranges::any_of(each.rows, [](const BenchRow& row) { return row.series.has_value(); });
        });
        return moves ? html + seriesTableOf(part) : html;
    }

    /// Along a camera path: the slowest frame, the wrong ones, and how long a cut is felt.
    static QString seriesTableOf(const Part& part)
    {
        QString html = QStringLiteral(
                           "<div class=\"wide\"><table><tr><th class=\"l\">%1</th><th "
                           "class=\"l\">%2</th><th>%3</th><th>%4</th><th>%5</th><th>%6</th><th>%7</th><th>%8</th></tr>")
                           .arg(Report::tr("scene"), Report::tr("algorithm"), Report::tr("threads"),
                                Report::tr("frames"), Report::tr("slowest, ms"), Report::tr("wrong frames"),
                                Report::tr("worst frame, % wrong"), Report::tr("wrong frames after each cut"));
        for (const ReportCase& each : part.cases)
            for (const BenchRow& row : each.rows) {
                if (!row.series) continue;
                const Series& series  = *row.series;
                const auto    slowest = std::ranges::max_element(series.frames, {}, &SeriesFrame::ms);
                const auto    wrong   = std::ranges::count_if(
                         series.frames, [](const SeriesFrame& frame) { return frame.wrongPixels.value_or(0) > 0; });
                QStringList lags;
                for (const Lag& lag : series.lags)
                    lags << (lag.frames ? QString::number(*lag.frames) : Report::tr("all"));
                html +=
                    QStringLiteral(
                        "<tr><td class=\"l\">%1</td><td "
                        "class=\"l\">%2</td><td>%3</td><td>%4</td><td>%5</td><td>%6</td><td>%7</td><td>%8</td></tr>")
                        .arg(each.scene.toHtmlEscaped(), shown(row.algorithm), QString::number(row.threads),
                             QString::number(series.frames.size()), decimal(slowest->ms, 3),
                             row.wrongPixels ? QString::number(wrong) : QString(),
                             row.wrongPixels ? decimal(100 * worstShare(series), 2) : QString(),
                             lags.join(QStringLiteral(", ")));
            }
        return html + QStringLiteral("</table></div>");
    }

    static bool isPeer(const BenchRow& row) { return row.algorithm.starts_with("peer:"); }

    QString rowOf(const ReportCase& each, const BenchRow& row, const std::vector<Stage>& stages) const
    {
        const QString wrong = isPeer(row)        ? Report::tr("%1 differ").arg(grouped(row.wrongPixels.value_or(0)))
                              : !row.wrongPixels ? Report::tr("not checked")
                              : row.isBroken()   ? Report::tr("%1, wrong").arg(grouped(*row.wrongPixels))
                                                 : grouped(*row.wrongPixels);
        const auto    time  = [&row](const QString& text) {
            return row.isBroken() ? QStringLiteral("<s>%1</s>").arg(text) : text;
        };
        QString html = QStringLiteral(
                           "<tr><td class=\"l\">%1</td><td class=\"l\">%2</td><td>%3</td><td "
                           "class=\"l\">%7</td><td>%4</td><td>%5</td><td class=\"soft\">%6</td>")
                           .arg(each.scene.toHtmlEscaped(), shown(row.algorithm), QString::number(row.threads), wrong,
                                time(decimal(row.medianMs, 3)),
                                time(QStringLiteral("%1, %2 – %3")
                                         .arg(decimal(row.bestMs, 3), decimal(row.q1Ms, 3), decimal(row.q3Ms, 3))),
                                row.shaded ? Report::tr("shaded") : Report::tr("ids and depth"));
        if (!m_record.head.baseline.empty()) html += ratioOf(each, row);
        for (const Stage stage : stages)
            html += QStringLiteral("<td class=\"soft\">%1</td>").arg(time(decimal(msOf(row, stage), 3)));
        return html + QStringLiteral("</tr>");
    }

    QString ratioOf(const ReportCase& each, const BenchRow& row) const
    {
        const auto base = std::ranges::find_if(each.rows, [&](const BenchRow& other) {
            return other.algorithm == m_record.head.baseline && other.threads == row.threads
                   && other.shaded == row.shaded;
        });
        if (base == each.rows.end() || base->isBroken() || row.isBroken() || row.roundMs.empty()
            || row.roundMs.size() != base->roundMs.size())
            return QStringLiteral("<td></td><td></td>");
        const PairedRatio ratio = pairedRatio(row.roundMs, base->roundMs);
        return QStringLiteral("<td>%1</td><td class=\"soft\">%2</td>")
            .arg(decimal(ratio.median, 2),
                 row.roundMs.size() > 1 ? QStringLiteral("%1 – %2").arg(decimal(ratio.low, 2), decimal(ratio.high, 2))
                                        : QString());
    }

    static double msOf(const BenchRow& row, Stage stage) { return row.stageMs[static_cast<std::size_t>(stage)]; }

    const Record&     m_record;
    std::string       m_folder;
    std::vector<Part> m_parts;
};

}  // namespace

Result<std::string> writeReport(const std::string& record, const std::string& folder)
{
    const auto text = readRegularFile(record, kMaxRecordFile);
    if (!text) return text.error();
    const Result<Record> read = recordFromJson(*text, record);
    if (!read) return read.error();
    PageWriter report(*read, folder);
    if (const auto done = report.read(); !done) return Error{Trouble::Input, done.error().sentence, record};

    std::error_code trouble;
    std::filesystem::create_directories(folder, trouble);
    if (trouble) return Error{Trouble::Output, "this folder cannot be made: " + trouble.message(), folder};
    if (const auto done = report.write(); !done) return done.error();
    return folder + "/index.html";
}

}  // namespace zscope::ui
