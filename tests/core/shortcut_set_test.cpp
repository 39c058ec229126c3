// Sets of shortcuts and the words that stand for them.
#include <gtest/gtest.h>

#include <set>

#include "core/frame/shortcuts.h"

namespace zscope::tests {
namespace {

TEST(ShortcutWords, AreReadAndWritten)
{
    EXPECT_EQ(shortcutsOf("all").value(), ShortcutSet::all());
    EXPECT_EQ(shortcutsOf("none").value(), ShortcutSet());
    for (int i = 0; i < kShortcutCount; ++i) {
        const auto        shortcut = static_cast<Shortcut>(i);
        const std::string name(entryOf(shortcut).name);
        EXPECT_EQ(shortcutsOf(name).value(), with({}, shortcut)) << name;
        EXPECT_EQ(shortcutsOf("all-" + name).value(), without(ShortcutSet::all(), shortcut)) << name;
        for (const ShortcutSet set : {with({}, shortcut), without(ShortcutSet::all(), shortcut)})
            EXPECT_EQ(shortcutsOf(wordsOf(set)).value(), set) << wordsOf(set);
    }
    EXPECT_EQ(shortcutsOf("windows,tile-planes").value(), with(with({}, Shortcut::Windows), Shortcut::TilePlanes));
}

TEST(ShortcutWords, ThatNoShortcutHasAreRefusedWithThoseThatOneHas)
{
    for (const char* words : {"", "window", "all-", "all-none", "windows,", ",windows", "none,windows"}) {
        const auto set = shortcutsOf(words);
        ASSERT_FALSE(set) << words;
        EXPECT_EQ(set.error().kind, Trouble::Usage);
        EXPECT_NE(set.error().sentence.find("tile-planes"), std::string::npos);
    }
}

TEST(ShortcutTable, AddsWhatIsNeededAndLeavesOutWhatNeedsIt)
{
    const ShortcutSet whole = with({}, Shortcut::WholeNodes);
    EXPECT_TRUE(whole.has(Shortcut::HiddenSquares));
    EXPECT_TRUE(whole.has(Shortcut::TwoLevelPyramid));
    EXPECT_TRUE(whole.has(Shortcut::Lanes));
    EXPECT_FALSE(without(ShortcutSet::all(), Shortcut::TwoLevelPyramid).has(Shortcut::WholeNodes));
    EXPECT_TRUE(without(ShortcutSet::all(), Shortcut::Lanes).isEmpty());
    for (int i = 1; i < kShortcutCount; ++i) EXPECT_TRUE(with({}, static_cast<Shortcut>(i)).has(Shortcut::Lanes)) << i;
}

TEST(ShortcutTable, HasANameOfItsOwnForEachAndAMethodForEach)
{
    std::set<std::string_view> names;
    for (int i = 0; i < kShortcutCount; ++i) {
        const ShortcutEntry& entry = entryOf(static_cast<Shortcut>(i));
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
        int presetsThatCan = 0;
        for (const Preset& preset : presets()) presetsThatCan += entry.whyNot(preset.pipeline).empty();
        EXPECT_GT(presetsThatCan, 0) << entry.name;
    }
}

}  // namespace
}  // namespace zscope::tests
