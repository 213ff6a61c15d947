#pragma once

namespace clapotis {

/// Speaks what `--lang en` or `--lang fr` asks for, or else, where the first of LC_ALL, LC_MESSAGES and LANG
/// that is not empty begins with "fr", French. To be called before anything is said. Throws BadInput for
/// another --lang.
void choose_language(int argc, const char* const* argv);

}  // namespace clapotis
