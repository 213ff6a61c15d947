#pragma once

namespace clapotis {

/// What window and command line speak. What is typed and what programs read (names of parameters, scenes and
/// columns, the keys of files) is the same in all.
enum class Language { english, french };

/// The language in use: English until `speak` says another.
Language language();

/// Chooses the language of what is said from now on, in all threads.
void speak(Language language);

}  // namespace clapotis
