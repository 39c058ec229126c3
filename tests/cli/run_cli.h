// Runs the real command line as a process of its own, as scripts do, and reads back what it wrote.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace zscope::cli_test {

inline const std::string kTeapot = "builtin:teapot?tessellation=3";

struct Answer {
    int         status = -1;  // exit status; 1000 + n if signal n ended it
    std::string out;
    std::string err;
};

Answer run(const std::vector<std::string>& arguments);
/// Starts it, waits until it catches `signal`, a little longer, and sends it.
Answer runAndSignal(const std::vector<std::string>& arguments, int signal, int milliseconds);
/// Starts it with an output into this FIFO, sends `signal` once the first bytes are there, then reads them all: they
/// are `out`.
Answer runIntoFifoAndSignal(const std::string& fifo, const std::vector<std::string>& arguments, int signal);
/// Runs it with standard output connected to a file or device.
Answer runInto(const std::string& outFile, const std::vector<std::string>& arguments);

std::string contentsOf(const std::filesystem::path& file);

/// A JUnit (.xml) or Gradescope (.json) report against its schema in tests/check, by xmllint or Python's jsonschema.
void expectFitsSchema(const std::string& report);

/// A folder of its own for each test, removed afterwards.
class Cli : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    std::string path(const std::string& name) const { return (m_folder / name).string(); }
    std::string write(const std::string& name, const std::string& contents) const;
    std::size_t filesInFolder() const;

private:
    std::filesystem::path m_folder;
};

}  // namespace zscope::cli_test
