#include "core/plain/set_up_all.h"

#include <new>

#include "core/plain/batches_in_view.h"

namespace zscope::plain {

void keepTriangles(Work& work, std::vector<ScreenTriangle>& all)
{
    all.insert(all.end(), work.scratch.triangles.begin(), work.scratch.triangles.end());
    if (all.capacity() * sizeof(ScreenTriangle) > work.stripe.memory) throw std::bad_alloc();
}

std::vector<ScreenTriangle> setUpAll(Work& work, const Parts& parts)
{
    std::vector<ScreenTriangle> all;
    for (const BatchPlace& batch : BatchesInView(work)) {
        if (!parts.mayBeSeen(work, batch)) continue;
        parts.setUp(work, batch);
        keepTriangles(work, all);
    }
    return all;
}

}  // namespace zscope::plain
