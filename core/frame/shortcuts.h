// The shortcuts by name: what each replaces, which others it needs, and where the method rules it out.
//
// Kinds      replacement: the same part, faster. filter: leaves out only what cannot win a pixel. order: another order
//            of visiting, or coarser nodes. storage: pixels, tiles, edges or cells kept in another form
// Sets       who adds a shortcut adds what it needs; who leaves one out leaves out what needs it
// Contract   no set changes a bit of the picture
// Growing    an enumerator in core/base/shortcut.h, a row in kShortcuts, and the place that asks for it
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/shortcut.h"
#include "core/frame/pipeline.h"

namespace zscope {

enum class ShortcutKind { Replacement, Filter, Order, Storage };
std::string_view wordOf(ShortcutKind kind);

struct ShortcutEntry {
    std::string_view          name;
    std::string_view          title;
    ShortcutKind              kind;
    std::string_view          replaces;  // what the plain text does instead
    std::span<const Shortcut> needs;     // directly; all of them need Lanes
    /// Why the pipeline cannot have it, in one sentence; empty if it can.
    std::string_view (*whyNot)(const Pipeline&);
};

/// In the order of enum Shortcut.
std::span<const ShortcutEntry> shortcutEntries();
const ShortcutEntry&           entryOf(Shortcut shortcut);

ShortcutSet with(ShortcutSet set, Shortcut added);    // and what it needs
ShortcutSet without(ShortcutSet set, Shortcut left);  // nor what needs it

/// "all", "none", names with commas between them, or "all-NAME": all but this one. Errors (Usage) name the words that
/// would have been right.
Result<ShortcutSet> shortcutsOf(std::string_view words);
/// The words that stand for the set: "all", "none", "all-NAME" or names with commas between them.
std::string wordsOf(ShortcutSet set);

/// Why the pipeline runs the plain text, whatever shortcuts are chosen; empty if it need not.
std::string_view whyPlain(const Pipeline& pipeline);
/// The shortcuts of the set that the pipeline can have.
ShortcutSet applicable(ShortcutSet set, const Pipeline& pipeline);

/// What became of a shortcut in a frame.
struct ShortcutUse {
    std::string_view name;
    bool             applies = false;
    std::string      why;  // in one sentence
};
/// Of all of them, where `chosen` were chosen.
std::vector<ShortcutUse> usesOf(ShortcutSet chosen, const Pipeline& pipeline);

}  // namespace zscope
