#!/usr/bin/env bash
# What ./lab promises, on a copy of it in a folder with a space, with stand-ins for apt, cmake and two stages.
set -u
here=$(dirname "$(readlink -f "$0")")
box=$(mktemp -d)
trap 'rm -rf "$box"' EXIT
house="$box/a house"
failures=0

# expect TITLE STATUS PATTERN COMMAND...: the command ends with STATUS, and what it prints matches PATTERN.
expect() {
  local said status
  said=$(cd "$box" && "${@:4}" 2>&1 < /dev/null); status=$?
  [[ $status == "$2" && $said =~ $3 ]] && { echo "ok: $1"; return; }
  printf 'FAILED: %s\n  exit code %s instead of %s, expected /%s/ in:\n%s\n' "$1" "$status" "$2" "$3" "$said"
  failures=$((failures + 1))
}

# stand_in NAME: a command of this name, whose script is the standard input.
stand_in() { { echo '#!/usr/bin/env bash'; cat; } > "$box/tools/$1"; chmod +x "$box/tools/$1"; }

mkdir -p "$house"/stage{1_bouncing,2_cloud} "$box/tools"
touch "$house"/stage{1_bouncing,2_cloud}/main.cpp "$house/CMakePresets.json"
mkdir -p "$house"/report/{bench/peers,figures}
cp "$here/../../report/figures/draw" "$house/report/figures/"
touch "$house"/report/figures/{style,orders}.gp
cp "$here/../../lab" "$house/lab"
export PATH="$box/tools:$PATH" BOX=$box
unset DISPLAY WAYLAND_DISPLAY CI LC_ALL LC_MESSAGES LANG
cat > "$house/report/bench/peers/pysph_dam_break.py" <<< $'#!/usr/bin/env bash\necho "peer $*"; exit 5'
chmod +x "$house/report/bench/peers/pysph_dam_break.py"
cp "$here/../../report/bench/peers/beside.py" "$house/report/bench/peers/"
# shellcheck disable=SC2016  # to be expanded by the stand-ins
stand_in dpkg-query <<< '[[ -e $BOX/installed ]] && for name in "${@:4}"; do echo "$name installed"; done'
stand_in dpkg <<< ':'
stand_in sudo <<'SUDO'
[[ -e $BOX/forbidden ]] && exit 1
[[ $1 == -* ]] && shift
exec "$@"
SUDO
stand_in apt-get <<'APT'
[[ -e $BOX/offline ]] && { echo 'E: no network'; exit 100; }
[[ $* == *install* ]] && echo 'Setting up cmake' && : > "$BOX/installed"
:
APT
stand_in ctest <<< 'echo "ctest $*"; exit 8'
stand_in stage <<'STAGE'
[[ $* == *--headless* || -n ${DISPLAY:-} ]] || exit 3
echo "${0##*/} $*"
[[ $* == *diverge* ]] && exit 5
[[ $* == *--headless* ]] && mkdir -p "runs/${0##*/}" && : > "runs/${0##*/}/picture.png"
:
STAGE
stand_in study <<'STUDY'
echo "study $*"
[[ $1 == -* || $# == 0 ]] && exit
folder=runs/studies; [[ $* == *--quick* ]] && folder=runs/studies-quick
all="$*"; [[ $all == *--out* ]] && folder=${all##*--out }
mkdir -p "$folder" && echo 'x,y' > "$folder/orders.csv" && echo 'found' > "$folder/orders.tex"
[[ ! -e $BOX/stopped ]] || exit 130
STUDY
# shellcheck disable=SC2016
stand_in class_diagram <<< ': > "$1"'
# shellcheck disable=SC2016
stand_in screens <<< ': > "$1/dam_break.png"'
stand_in gnuplot <<'GNUPLOT'
figure=${2##*figure=\'}
: > "${figure%\'}"
GNUPLOT
# shellcheck disable=SC2016
stand_in pdflatex <<< 'echo pdfTeX; : > "${*: -2:1}/report.pdf"'
stand_in cmake <<'CMAKE'
if [[ $1 == --preset ]]; then
  mkdir -p build/release/bin && : > build/release/build.ninja
  printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\nCLAPOTIS_WERROR:BOOL=OFF\n' "$PWD" > build/release/CMakeCache.txt
  echo configured >> "$BOX/configured"
else
  [[ -e $BOX/broken ]] && { echo 'error: expected ;'; exit 1; }
  [[ -e $BOX/full ]] && { echo 'write: No space left on device'; exit 1; }
  for name in stage1_bouncing stage2_cloud bench compare; do cp "$BOX/tools/stage" "build/release/bin/$name"; done
  for name in study class_diagram screens; do cp "$BOX/tools/$name" "build/release/bin/$name"; done
  echo 'ninja: no work to do.'
fi
CMAKE

lab="$house/lab"
expect 'alone, it lists what it can do' 0 'run STAGE' "$lab"
expect 'a misspelt verb is answered with the nearest one' 2 'nearest is "bench"' "$lab" bnech
expect 'a misspelt stage is answered with the nearest one' 2 'nearest is "stage2_cloud"' "$lab" run stage2_clod
: > "$box/offline"
expect 'it speaks French to whom does so' 0 'toutes les étapes' env LANG=fr_FR.UTF-8 "$lab"
expect '... or is asked to' 2 'Il n.*pas de verbe.*bnech.*Le plus proche est.*bench' "$lab" bnech --lang fr
expect '... but not when told otherwise' 2 'nearest is "bench"' env LC_ALL=fr_FR.UTF-8 "$lab" bnech --lang=en
expect 'every sentence has its French' 0 '^$' bash -c \
  "source <(sed -n '/^declare -A english/,/^declare -n/p' '$here/../../lab' | sed '\$d')
   for key in \"\${!english[@]}\"; do [[ \${french[\$key]:-} ]] || echo \"\$key\"; done
   for key in \"\${!french[@]}\"; do [[ \${english[\$key]:-} ]] || echo \"\$key\"; done"
expect 'without a network it says what to type' 69 'no network.*apt-get update && .*apt-get install .*libsfml-dev' "$lab" run
expect 'what a peer needs is installed on demand' 69 'apt-get install .*python3-pysph' "$lab" bench --peer=pysph
rm "$box/offline"
: > "$box/forbidden"
[[ $EUID == 0 ]] || expect 'without rights it says what to ask for' 69 'administrator.*sudo apt-get install .*cmake' "$lab" run
rm "$box/forbidden"
expect 'the first tour installs, builds and runs every stage headless' 0 \
  'Installing.*No usable display.*stage1_bouncing --headless.*stage2_cloud --headless.*runs/stage2_cloud/picture.png' "$lab" run
expect 'the results are in the folder it was called from' 0 'stage1_bouncing' ls "$box/runs"
expect 'options reach the stage as they were typed' 0 'stage2_cloud grid --set name=a b --headless' \
  "$lab" run stage2_cloud grid --set 'name=a b'
expect 'once all is there it adds no word of its own' 0 '^stage2_cloud --list scenes$' \
  env DISPLAY=:0 "$lab" run stage2_cloud --list scenes
expect 'with a display, stages open their windows one after another' 0 'stage1_bouncing .*stage2_cloud ' \
  env DISPLAY=:0 "$lab" run
expect 'the exit code of a stage ends the tour' 5 '^[^2]*$' env DISPLAY=:0 "$lab" run --set diverge=1
expect 'ctest has the last word, and its exit code passes through' 8 'ctest --preset release -j [0-9]+ -R window$' \
  "$lab" test -R window
expect 'compare passes its arguments on' 0 '^compare A B --headless$' "$lab" compare A B --headless
expect 'the list of studies draws nothing' 0 '^study $' "$lab" study
expect 'a study is measured and drawn where it was asked for' 0 '^study orders --quick --out here' \
  "$lab" study orders --quick --out here
expect '... as a figure beside its table' 0 '^orders.pdf$' ls "$box/here" --ignore '*.csv' --ignore '*.tex'
: > "$box/stopped"
expect 'a study that was stopped says so' 130 '^study orders' "$lab" study orders
rm "$box/stopped"
expect 'the report refuses an option that it has not' 2 'takes --quick.*not "--fast"' "$lab" report --fast
expect 'the report measures, draws, and sets itself' 0 '^study all --quick.*Typesetting.*report/report.pdf$' \
  "$lab" report --quick
expect '... and is there' 0 'report.pdf' ls "$house/report"
expect 'a misspelt peer is answered with the nearest one' 2 'no peer "pyshp".*nearest is "pysph"' \
  "$lab" bench --peer pyshp
expect 'a peer has the last word, and its figures a place' 5 $'^turn 1 of 3\npeer --json runs/peers/pysph.json --dx 0.02$' \
  "$lab" bench --peer pysph --dx 0.02
expect 'it configured once' 0 '^1$' grep -c configured "$box/configured"
: > "$box/broken"
expect 'a failed build shows why' 70 'expected ;' "$lab" bench
rm "$box/broken"
: > "$box/full"
expect 'a full disk is named' 70 'The disk is full' "$lab" bench
rm "$box/full"
mv "$house" "$box/elsewhere"
expect 'a folder that moved is configured again' 0 'compare' "$box/elsewhere/lab" compare --headless
expect 'once, and only once' 0 '^2$' grep -c configured "$box/configured"
mkdir -p "$box/elsewhere/runs"
expect 'clean removes the build' 0 '^$' "$box/elsewhere/lab" clean
expect 'clean keeps the results' 0 '^runs$' bash -c 'cd elsewhere && ls -d runs build 2> /dev/null; :'
exit $((failures > 0))
