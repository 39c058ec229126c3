// When a fragment is shaded: with the finished picture, or before or after its depth test.
#pragma once

namespace zscope {

enum class ShadingMoment {
    Never,       // the picture is shaded when it is finished, or not at all
    BeforeTest,  // every covered fragment, whether it will be seen or not
    AfterTest,   // those that passed the test
};

}  // namespace zscope
