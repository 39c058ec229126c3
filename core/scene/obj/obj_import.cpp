#include "core/scene/obj/obj_import.h"

#include <exception>
#include <istream>
#include <new>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "core/base/memory.h"
#include "core/base/stopwatch.h"
#include "core/io/read_file.h"
#include "core/io/text_encoding.h"
#include "core/scene/obj/line_reader.h"
#include "core/scene/obj/obj_builder.h"
#include "core/scene/obj/statement_stream.h"

namespace zscope {

namespace {

using obj::LineReader;
using obj::ObjBuilder;
using obj::StatementStream;

/// What tinyobjloader calls back. No exception passes through it: the first one ends the file and is kept.
class Callbacks : public tinyobj::MaterialReader {
public:
    Callbacks(ObjBuilder& builder, StatementStream& stream) : m_builder(builder), m_stream(stream) {}

    void run()
    {
        tinyobj::callback_t table;
        table.vertex_cb = [](void* self, auto...) {
            of(self).guard([](Callbacks& c) { return c.m_builder.addVertex(c.m_stream.current()); });
        };
        table.index_cb = [](void* self, tinyobj::index_t*, int) {
            of(self).guard([](Callbacks& c) { return c.m_builder.addFace(c.m_stream.current()); });
        };
        table.usemtl_cb = [](void* self, const char*, int) {
            of(self).guard([](Callbacks& c) { return c.m_builder.useMaterial(c.m_stream.current()); });
        };
        table.group_cb = [](void* self, const char**, int) {
            of(self).guard([](Callbacks& c) { return c.m_builder.useGroup(c.m_stream.current()); });
        };
        table.object_cb = [](void* self, const char*) {
            of(self).guard([](Callbacks& c) { return c.m_builder.useObject(c.m_stream.current()); });
        };
        std::istream statements(&m_stream);
        tinyobj::LoadObjWithCallback(statements, table, this, this, nullptr, nullptr);
        if (m_exception) std::rethrow_exception(m_exception);
        if (m_stream.failure()) std::rethrow_exception(m_stream.failure());
    }

    bool operator()(const std::string&, std::vector<tinyobj::material_t>*, std::map<std::string, int>*, std::string*,
                    std::string*) override
    {
        guard([](Callbacks& c) { return c.m_builder.addLibrary(c.m_stream.current()); });
        return true;
    }

private:
    static Callbacks& of(void* self) { return *static_cast<Callbacks*>(self); }

    template <class Action>
    void guard(const Action& action) noexcept
    {
        try {
            if (!action(*this)) m_stream.halt();
        } catch (...) {
            m_exception = std::current_exception();
            m_stream.halt();
        }
    }

    ObjBuilder&        m_builder;
    StatementStream&   m_stream;
    std::exception_ptr m_exception;
};

Result<ObjImport> importChecked(std::string_view text, const std::string& name, const std::string& folder,
                                const ObjOptions& options, obj::MemoryBudget budget)
{
    if (text.empty()) return Error{Trouble::Input, "the file is empty", name};
    if (const auto trouble = encodingTrouble(text)) return Error{Trouble::Input, *trouble, name};

    bool       isCancelled = false;
    LineReader lines(text);
    const auto keepGoing = [&] {
        options.progress.at(static_cast<double>(lines.position()) / static_cast<double>(text.size()), "reading");
        isCancelled = options.progress.cancelled();
        return !isCancelled;
    };
    if (!keepGoing()) return Error{Trouble::Cancelled, "loading was cancelled", name};

    StatementStream stream(lines, keepGoing);
    ObjBuilder      builder(name, folder, budget);
    Callbacks(builder, stream).run();
    if (isCancelled) return Error{Trouble::Cancelled, "loading was cancelled", name};
    if (lines.tooLong())
        return Error{Trouble::Limit, fmt::format("the line is longer than {} MiB", obj::kMaxLineBytes >> 20), name,
                     lines.number()};
    auto import = std::move(builder).finish(stream);
    if (import.ok()) options.progress.at(1, "reading");
    return import;
}

}  // namespace

Result<ObjImport> importObjText(std::string_view text, const std::string& name, const std::string& folder,
                                const ObjOptions& options)
{
    const std::uint64_t limit = effectiveMemoryLimit(options.memoryLimit);
    try {
        return importChecked(text, name, folder, options, obj::MemoryBudget(limit, text.size()));
    } catch (const std::bad_alloc&) {
        return Error{Trouble::Limit, "there is not enough memory for the model", name};
    }
}

Result<ObjImport> importObj(const std::string& path, const ObjOptions& options)
{
    Stopwatch  watch;
    const auto text = readRegularFile(path, effectiveMemoryLimit(options.memoryLimit));
    if (!text.ok()) return text.error();
    const auto folder = folderOf(path);
    if (!folder.ok()) return folder.error();
    const double readMs = watch.lap();
    auto         import = importObjText(*text, path, *folder, options);
    if (!import.ok()) return import;
    import->readMs  = readMs;
    import->parseMs = watch.lap();
    return import;
}

}  // namespace zscope
