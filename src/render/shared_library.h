// A library opened when it is first needed: a program that draws nothing neither loads it nor waits for it.
#pragma once

#include <string>

namespace drape {

class SharedLibrary {
public:
    // Throws Error (Exit::cannot_write) with `advice` if it is not installed.
    SharedLibrary(const char* file, const char* advice);

    // Throws Error (Exit::cannot_write) if the library has no such function.
    template <class Function>
    Function* find(const char* name) const {
        return reinterpret_cast<Function*>(symbol(name));
    }

private:
    void* symbol(const char* name) const;

    std::string file_;
    void* handle_;  // stays open: drivers leave threads and exit handlers behind
};

}  // namespace drape
