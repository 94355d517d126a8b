#pragma once

#include <string>
#include <vector>

namespace druse::test {

inline const std::string models = DRUSE_MODELS; // the folder of models to open

/// How a run of a program ended.
struct Ended {
    int status = -1; // exit status; 128 + N after signal N
    std::string out, err;
};

enum class Interrupt { never, when_it_speaks };

/// Runs `program` with these arguments in `folder`, with `input` as its standard input. `when_it_speaks` sends SIGINT as soon as there is
/// something on its standard output.
Ended run_program(const std::string& program, const std::vector<std::string>& arguments, const std::string& folder = ".", const std::string& input = {},
                  Interrupt interrupt = Interrupt::never);

/// The same for the `druse` that was built.
Ended druse(const std::vector<std::string>& arguments, const std::string& folder = ".", const std::string& input = {},
            Interrupt interrupt = Interrupt::never);

/// True if a program of that name is on the path.
bool is_installed(const std::string& program);

} // namespace druse::test
