# cmake -DROOT=FOLDER -DSTAGES=NAME,NAME -DOUT=FILE.cpp -P embed.cmake: writes the exercises of these stages, README.md
# and exercises.fr.md, as they are, into a source file.
set(text "#include <array>\n\n#include \"common/lesson/texts.hpp\"\n\nnamespace clapotis {\n\n")
string(APPEND text "std::span<const LessonText> lesson_texts() {\n  static constexpr std::array texts{")
string(REPLACE "," ";" stages "${STAGES}")
foreach(stage IN LISTS stages)
  file(READ "${ROOT}/${stage}/README.md" readme)
  file(READ "${ROOT}/${stage}/exercises.fr.md" french)
  string(APPEND text
    "\n    LessonText{\"${stage}\", R\"lesson(${readme})lesson\",\n               R\"lesson(${french})lesson\"},")
endforeach()
string(APPEND text "};\n  return texts;\n}\n\n}  // namespace clapotis\n")
file(WRITE "${OUT}" "${text}")
