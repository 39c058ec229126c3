// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheet/sheet_writer.h"

#include <QApplication>
#include <QBuffer>
#include <QFile>
#include <QFontMetrics>
#include <QImage>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>

#include "core/io/file_writer.h"
#include "core/io/png.h"
#include "ui/session/reproduce.h"
#include "ui/text/phrase_book.h"
#include "ui/text/utf8_text.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr int kDotsPerInch = 96;

/// Draws by a painter that begin() makes.
class PaintedCanvas : public SheetCanvas {
public:
    int width(std::string_view utf8, int size) override
    {
        return QFontMetrics(fontOfHeight(size)).horizontalAdvance(said(utf8));
    }
    void text(int x, int y, std::string_view utf8, int size, std::uint32_t colour) override
    {
        write(x, y, said(utf8), size, colour);
    }
    void name(int x, int y, std::string_view utf8, int size, std::uint32_t colour) override
    {
        write(x, y, utf8Text(utf8), size, colour);
    }
    void fill(int x0, int y0, int x1, int y1, std::uint32_t colour) override
    {
        m_painter.fillRect(x0, y0, x1 - x0, y1 - y0, QColor::fromRgb(colour));
    }
    void picture(int x, int y, int width, int height, const Grid<std::uint32_t>& pixels) override
    {
        const QImage image(reinterpret_cast<const uchar*>(pixels.values().data()), pixels.width(), pixels.height(),
                           4 * pixels.width(), QImage::Format_RGB32);
        m_painter.setRenderHint(QPainter::SmoothPixmapTransform);
        m_painter.drawImage(QRect(x, y, width, height), scaled(image, width, height));
    }

protected:
    virtual QImage scaled(const QImage& image, int width, int height) const = 0;

    QPainter m_painter;

private:
    void write(int x, int y, const QString& words, int size, std::uint32_t colour)
    {
        m_painter.setFont(fontOfHeight(size));
        m_painter.setPen(QColor::fromRgb(colour));
        m_painter.drawText(x, y, words);
    }
};

class PictureCanvas final : public PaintedCanvas {
public:
    void begin(int width, int height) override
    {
        m_image = QImage(width, height, QImage::Format_RGB32);
        m_image.fill(Qt::white);
        m_painter.begin(&m_image);
    }
    QImage take()
    {
        m_painter.end();
        return m_image;
    }

private:
    QImage scaled(const QImage& image, int width, int height) const override
    {
        return image.size() == QSize(width, height)
                   ? image
                   : image.scaled(width, height, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }
    QImage m_image;
};

class PageCanvas final : public PaintedCanvas {
public:
    explicit PageCanvas(const SheetWords& words) : m_writer(&m_buffer)
    {
        m_buffer.open(QIODevice::WriteOnly);
        m_writer.setResolution(kDotsPerInch);
        m_writer.setCreator(QStringLiteral("ZScope " ZSCOPE_VERSION));
        m_writer.setTitle(QString::fromStdString(words.scene));
    }
    void begin(int width, int height) override
    {
        const double inch = 72.0 / kDotsPerInch;
        m_writer.setPageLayout(QPageLayout(
            QPageSize(QSizeF(width * inch, height * inch), QPageSize::Point, QString(), QPageSize::ExactMatch),
            QPageLayout::Portrait, QMarginsF()));
        m_painter.begin(&m_writer);
    }
    void attach(const QString& name, const std::string& json)
    {
        m_writer.addFileAttachment(name, QByteArray::fromStdString(json), QStringLiteral("application/json"));
    }
    std::string take()
    {
        m_painter.end();
        return m_buffer.data().toStdString();
    }

private:
    QImage scaled(const QImage& image, int, int) const override { return image; }  // the page keeps every pixel

    QBuffer    m_buffer;
    QPdfWriter m_writer;
};

}  // namespace

std::optional<QString> writeSheet(const QString& file, const zscope::Comparison& comparison, const Scene& scene,
                                  const SheetWords& words, const std::optional<Camera>& camera)
{
    const std::string name = QFile::encodeName(file).toStdString();
    Result<Done>      done = Done{};
    if (file.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive)) {
        PageCanvas canvas(words);
        if (camera) canvas.attach(QString::fromLatin1(kCameraFile), cameraToJson(*camera));
        drawSheet(comparison, scene, words, canvas);
        done = writeFile(name, canvas.take());
    } else {
        PictureCanvas canvas;
        drawSheet(comparison, scene, words, canvas);
        const QImage                        image = canvas.take();
        const GridView<const std::uint32_t> pixels{reinterpret_cast<const std::uint32_t*>(image.constBits()),
                                                   image.width(), image.height(),
                                                   static_cast<std::size_t>(image.bytesPerLine()) / 4};
        auto                                texts = reproducingTexts(words.command, scene.digest);
        if (camera) texts.push_back({kCameraFile, cameraToJson(*camera)});
        done = writePng(name, pixels, texts);
    }
    return done ? std::nullopt : std::optional(said(done.error()));
}

}  // namespace zscope::ui
