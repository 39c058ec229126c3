// Values derived from one fixed source, each made at most once, when the first user asks for it.
//
// Threads    get() may be called from any thread; two that ask for the same type wait for one making
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <typeindex>

namespace zscope {

class Derived {
public:
    /// The value of type T, made by `make()` (which returns a std::unique_ptr<T>) if this is the first request for it.
    template <class T, class Make>
    const T& get(const Make& make) const
    {
        const std::scoped_lock lock(m_mutex);
        std::shared_ptr<void>& slot = m_values[std::type_index(typeid(T))];
        if (!slot) slot = std::shared_ptr<T>(make());
        return *static_cast<const T*>(slot.get());
    }

private:
    mutable std::mutex                                       m_mutex;
    mutable std::map<std::type_index, std::shared_ptr<void>> m_values;
};

}  // namespace zscope
