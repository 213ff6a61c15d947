#include "common/words.hpp"

#include <atomic>

#include "common/words_french.hpp"

namespace clapotis {
namespace {

constexpr Words english{
    .unknown_parameter = "the scene has no parameter {name}; it has: {known}",
    .unknown_name = "there is no {kind} {name}; there is: {known}",
    .did_you_mean = "; did you mean {name}?",
    .value_out_of_range = "{name} = {value}{unit} is out of range: {name} must be {allowed}",
    .not_a_number = "{name} = {value} is not a finite number: {name} must be {allowed}",
    .not_an_integer = "{name} = {value} is not a whole number: {name} must be {allowed}",
    .not_a_choice = "{name} = {value} is not one of: {allowed}",
    .comma_for_dot =
        "{name} = {value} is not a number (decimals are written with a dot, 0.5): {name} must be {allowed}",
    .needs_restart = "{name} cannot change while the scene runs: it takes effect when the scene starts anew",
    .derived_parameter = "{name} follows from other parameters and cannot be set",
    .too_many_discs = "particles = {count} discs of radius {radius} {unit} do not fit: at most {most} do",
    .box_too_small =
        "radius = {radius} {unit} is too large: the disc needs a box wider than 2 radius, not {side} {unit}",
    .outside_box =
        "{name} = {value} {unit} is outside the walls: {name} must be between {low} and {high} {unit}",
    .no_time_step =
        "dt = auto finds no limit to take a share of (nothing moves, nothing falls): give dt a number of "
        "seconds",
    .vanishing_time_step =
        "dt = auto comes out as {dt} s from the {limit} limit {formula}: a speed, a mass or a stiffness is "
        "out "
        "of all proportion",
    .too_many_steps =
        "until = {until} s is {count} steps of dt = {dt} s away, beyond the {most} that can be counted: take "
        "a larger dt or a smaller until",
    .other_unit = "{name} = {value} is in {given}, but this scene's {name} is in {unit}",
    .from_place = "{place}: {sentence}",
    .threads_out_of_range = "threads = {value} is out of range: threads must be at least 1",
    .spacing_too_large = "spacing = {value} leaves no room for a single particle",
    .spacing_too_small = "spacing = {value} makes room for more than {most} particles",
    .no_room_for_drop = "there is no room for a drop at ({x}, {y}) {unit}: liquid and walls are in its place",
    .obstacle_over_liquid =
        "there is liquid at ({x}, {y}) {unit}: erase it first, or draw where there is none",
    .no_sound_speed =
        "sound_speed is 10 times the fastest flow, but nothing moves and nothing falls: give it in {unit}/s, "
        "for example --set sound_speed=10",
    .entry_twice = "{name} = {value} names {entry} twice",
    .integrator_of_particles =
        "{name} does not advance the density of a liquid: here the integrator is one of {known}",
    .any_finite = "any finite number",
    .range_above = "> {low}",
    .range_at_least = ">= {low}",
    .range_at_most = "<= {high}",
    .range_between = "between {low} and {high}",
    .or_auto = ", or auto",
    .each_or_none = " each, with commas between, or none",
    .none = "none",
    .diverged = "diverged at step {step}, t = {time} s, particle {particle}: {cause}",
    .diverged_speed =
        "its speed {speed} {unit} is beyond all that the scene's energy allows ({bound} {unit})",
    .diverged_nan = "its position, velocity or density is not a number",
    .cause_limit = "; dt = {dt} s is {ratio} times the {limit} limit {formula}",
    .cause_scheme =
        "; {integrator} is not stable here at dt = {dt} s: take a smaller dt or another integrator",
    .beyond_limit = "dt = {dt} s is {ratio} times the {limit} limit {formula}: expect the run to diverge",
    .warn_coincident =
        "two particles were at one point (times: {count}); they were pushed apart in a direction "
        "taken from their ids",
    .warn_coincident_fluid =
        "two particles of the liquid were at one point (times: {count}); no pressure parts them",
    .warn_folded =
        "a particle met the walls more often in one step than is followed (times: {count}); its "
        "reflections were counted instead",
    .unknown_option = "there is no option {option}, --help lists them all{hint}",
    .option_is_parameter = "there is no option {option}; for the parameter, write --set {name}=VALUE",
    .option_needs_value = "{option} needs a value",
    .option_takes_no_value = "{option} takes no value",
    .one_scene_at_a_time = "one scene at a time: {first}, or {second}?",
    .set_without_equals = "--set {text} lacks its value: write --set NAME=VALUE",
    .empty_value = "{option} needs a name, not an empty word",
    .no_seed = "scene {scene} leaves nothing to chance: --seed has no meaning here",
    .environment_ignored = "{variable} is ignored: scene {scene} has no such parameter{hint}",
    .needs_headless = "{option} is for a run without a window: add --headless",
    .needs_window = "{option} is for the window; without one, ./lab compare runs two scenes side by side",
    .beside_without_equals = "--beside {text} lacks its value: write --beside NAME=VALUE",
    .picture_extension = "--picture {file}: the name must end in .png, .svg or .pdf",
    .config_unknown_key = "{file}: there is no key {key}{hint}",
    .config_wrong_kind = "{file}: {key} cannot be {value}",
    .config_no_value = "{file}: {key} has no value",
    .config_key_twice = "{file}: {key} is given twice",
    .config_not_json = "{file}, line {line}: this is not JSON: {reason}",
    .config_other_stage = "{file} is of {other}, and this program is {stage}",
    .config_resumed = "{file} is of a run that went on from a saved state; this one begins at the start",
    .video_extension = "--video {file}: the name must end in .mp4",
    .option_without = "{option} has no meaning without {other}",
    .state_no_state = "{file} is not a saved state: --resume takes what --save, or F5 in the window, wrote",
    .state_other_format =
        "{file} is a state of format {format}, and this program reads format {own}: resume it with the "
        "program that wrote it",
    .state_cut_short =
        "{file} is cut short, {bytes} bytes of {whole}: copy it again from where it was saved, or run from "
        "the start",
    .state_damaged =
        "{file} is damaged: its bytes are not those that were saved; copy it again from where it was saved, "
        "or run from the start",
    .state_other_version =
        "{file} was saved by {other}, and this is {own}, which need not give the same bits: resume it with "
        "that version, or run from the start",
    .state_other_width =
        "{file} was saved by a program with vectors of {other}, and this one has vectors of {own}, which "
        "give "
        "other bits: resume it with a build for that processor, or run from the start",
    .state_other_build =
        "{file} was saved by another build of this program, which need not give the same bits: resume it "
        "with "
        "that build, or run from the start",
    .state_other_scene =
        "{file} is of scene {other}, not of {scene}: leave the scene out, or run {scene} without --resume",
    .state_contradiction =
        "{name} = {value} contradicts {file}, where {name} = {other}, and cannot change while the scene "
        "runs: leave it out, or run from the start without --resume",
    .state_at_end = "{file} stands at t = {time} s, step {steps}, already: {option} must be beyond",
    .resume_and_config =
        "--resume and --config: a resumed run has its values from the state; give what is to change with "
        "--set",
    .no_encoder =
        "there is no ffmpeg to make {file} with: install it (on Debian and Ubuntu: apt install ffmpeg), or "
        "leave the video out",
    .encoder_failed = "ffmpeg gave up on {file}: {reason}",
    .encoder_ended = "it ended with exit code {code}",
    .cannot_read = "cannot read {file}: {reason}",
    .cannot_write = "cannot write {file}: {reason}",
    .folder_exists =
        "{folder} exists and is not empty: choose another --out, or --force to replace an earlier run",
    .not_a_folder = "{folder} exists and is not a folder",
    .not_a_run_folder =
        "{folder} holds no {mark}, so it is not the folder of an earlier run: --force does not touch it",
    .no_display = "there is no display to open a window on: run {name} --headless, or set DISPLAY",
    .interrupted = "interrupted; what was computed so far is kept",
    .no_memory = "not enough memory: take fewer particles",
    .own_fault = "a fault of the program itself: {what}",
    .standard_output = "standard output",
    .no_greek_letters = "DejaVuSans.ttf not found, Greek letters will be missing (install fonts-dejavu-core)",
    .no_letters = "no text in the picture without DejaVuSans.ttf (install fonts-dejavu-core)",
    .progress = "{percent} %, {what}, {left} left",
    .summary_run =
        "{folder}: {reason} at t = {time} s\n"
        "  steps     {steps} of {dt} s with {integrator}, N = {particles}\n",
    .summary_cost =
        "  cost      {cpu} of processor time (x{speed} real time), {step} per step, {rate} particle updates "
        "per "
        "second\n",
    .summary_energy =
        "  energy    mechanical {start} to {end} {unit}; total drifts by {drift} of its start\n",
    .summary_error = "  error     {measure} = {error}{unit} at the end, {largest} at most ({reference})\n",
    .summary_saved = "  saved     {file}: step {step}, t = {time} s, from which --resume goes on\n",
    .summary_warning = "  warning   {warning}\n",
    .stopped_done = "done",
    .stopped_interrupted = "interrupted",
    .stopped_diverged = "diverged; this is the last good state,",
    .column_name = "name",
    .column_symbol = "symbol",
    .column_unit = "unit",
    .column_default = "default",
    .column_range = "range",
    .column_change = "change",
    .column_meaning = "meaning",
    .plot_energies = "Energies",
    .plot_error = "Error against {reference}",
    .kinetic = "kinetic",
    .potential = "potential",
    .elastic = "elastic",
    .internal = "compression",
    .mechanical = "mechanical",
    .total = "with what was lost",
    .measured_points = "u of the particles",
    .compare_side = "{side} is not STAGE/SCENE[:NAME=VALUE,...]",
    .compare_assignment = "{side}: {text} is not NAME=VALUE",
    .compare_two_sides = "a comparison takes two of STAGE/SCENE[:NAME=VALUE,...], not {count}",
    .compare_two_ends = "--until and --steps: a comparison ends at one of them",
    .compare_units = "the sides measure in {left} and in {right}: they cannot be compared",
    .compare_other_particles =
        "the sides do not have the same particles, {left} and {right} of them: errors, energies and cost are "
        "compared, places are not",
    .compare_other_start =
        "the sides do not begin alike: particles are up to {largest} {unit} apart at t = 0",
    .compare_title = "{folder}: compared until t = {time} s\n",
    .compare_side_line =
        "{name} {side}\n"
        "  steps     {steps} of {dt} s with {integrator}, {evaluations} force evaluations\n"
        "  cost      {cpu} s of processor time, {cost} ms per simulated second, {step} ms per step\n"
        "  energy    total drifts by {drift} of its start\n",
    .compare_left = "left",
    .compare_right = "right",
    .compare_end =
        "difference at the end: largest {largest} {unit} ({share} % of the box's diagonal), rms {rms} "
        "{unit}\n",
    .compare_largest =
        "difference at most:    {largest} {unit} ({share} %), at t = {time} s, particle {particle}\n",
    .compare_ratio = "right over left:       {cpu} in processor time, {step} per step\n",
    .compare_cost = "CPU {cost}   {evaluations} evaluations   energy {drift}",
    .compare_plot = "Difference",
    .compare_distance = "|r left - r right|",
    .compare_curve_largest = "largest",
    .compare_curve_rms = "rms",
    .help_compare =
        "Runs two scenes from the same start on a common clock and says how far apart they come. With the "
        "same "
        "time step they are compared after each step; otherwise at common instants, neither trajectory "
        "altered.",
    .help_side = "STAGE/SCENE[:NAME=VALUE,...]; NAME is a parameter, integrator or threads",
    .help_compare_steps = "stop after so many steps of the left side",
    .help_compare_every = "simulated time between two rows of compare.csv [s]",
    .help_compare_out = "the folder to leave; runs/compare-DATE otherwise",
    .help_compare_json = "print compare.json for a program to read",
    .help_scene = "the scene, by name; the first one otherwise",
    .help_headless = "no window; leaves a run folder and prints a summary",
    .help_until = "stop at this simulated time [s]; 5 when neither --until nor --steps is given",
    .help_steps = "stop after so many steps",
    .help_set = "a parameter; may be repeated, of one name the last counts",
    .help_config = "values from a file, or from the run.json of an earlier run, which it repeats",
    .help_print_config = "print every value, its unit and where it comes from, and end",
    .help_preset = "a set of values that comes with the scene: see --list presets; --set counts more",
    .help_colour_by = "what the colours of pictures show: speed, pressure, vorticity, ... or plain",
    .help_integrator = "the scheme: see --list integrators",
    .help_seed = "short for --set seed=N",
    .help_threads = "1 to 1024; results do not depend on it",
    .help_out = "the run folder; runs/STAGE-SCENE-DATE otherwise",
    .help_force = "replace the earlier run in --out",
    .help_every =
        "simulated time between two rows of series.csv [s]; otherwise each step of a short run, some "
        "500 rows of a long one",
    .help_frames = "also write all particles to frames/NNNN.csv at this interval [s]",
    .help_vtk =
        "also write all particles to vtk/NNNN.vtu at this interval [s], and vtk.pvd, which ParaView opens",
    .help_picture = "also write a picture here, .png, .svg or .pdf",
    .help_video = "also make a film, which needs ffmpeg",
    .help_video_every =
        "simulated time between two frames of it, 30 of which last a second [s]; otherwise in real time, "
        "but from 5 to 60 seconds long",
    .help_save =
        "save the state at the end, from which --resume goes on; the last step that --until altered is not "
        "in it",
    .help_resume =
        "go on from a saved state, bit for bit; --until and --steps count from the first start, and live "
        "parameters may change",
    .help_list = "print scenes, parameters, integrators or kernels, and end",
    .help_json = "print run.json (or the list) for a program to read",
    .help_quiet = "print nothing but errors",
    .help_paused = "open the window at rest",
    .help_beside =
        "open the window with the scene twice, side by side; the right side has this value, for example "
        "integrator=rk4",
    .help_scale = "size of the window's letters, 0.25 to 8",
    .help_theme = "colours of window, pictures and films: light or dark",
    .help_lang = "en or fr; otherwise as LC_ALL, LC_MESSAGES or LANG says",
    .help_version = "print the version, and end",
    .help_help = "print this, and end",
    .help_epilogue =
        "Scenes: {scenes}\n\n"
        "A value comes from --set and the other options, or else from the environment (CLAPOTIS_GRAVITY=3),\n"
        "or else from the file of --config, or else from the scene. Decimals have a dot.\n\n"
        "Exit codes: 0 done, 1 a check failed, 2 usage or bad parameter, 3 no display, 4 input or output,\n"
        "5 diverged, 130 interrupted (what was computed is kept).\n\n"
        "Example: {stage} {scene} --headless --until 2 --set gravity=3 --out runs/moon",
    .help_usage = "Usage",
    .help_arguments = "Positionals",

    .window =
        {
            .run = "Run",
            .pause = "Pause",
            .step = "Step",
            .reset = "Reset",
            .speed = "speed",
            .slower_than_asked = "runs at x{factor}",
            .scene = "scene",
            .preset = "preset",
            .integrator = "integrator",
            .live = "Parameters (live)",
            .restart = "Start (a change restarts)",
            .defaults = "Defaults",
            .automatic = "auto",
            .type_hint = "{meaning}\n{allowed}\nCtrl-click or right-click to type a value",
            .time_step = "Time step",
            .close_to_instability = "close to the limit of stability",
            .beyond_stability = "beyond the limit of stability",
            .view = "View",
            .colour_by = "colour",
            .lock_range = "lock",
            .grid = "grid",
            .vectors = "velocities",
            .plots = "energies",
            .letters = "letters",
            .dark = "dark",
            .cost = "Cost",
            .particles = "N = {count}",
            .step_cost = "{time} per step",
            .real_time = "x{factor} real time",
            .picture = "picture",
            .video = "video",
            .stop_video = "stop",
            .table = "CSV",
            .grid_file = "VTK",
            .save = "save",
            .restore = "restore",
            .recording = "recording, {seconds} s",
            .pairs_near = "{count} pairs in reach",
            .pairs_tested = "of {count} tested",
            .frames = "{count} frames/s",
            .frame_cost = "{time} to paint one",
            .particle = "particle {id}",
            .position = "r",
            .velocity = "v",
            .speed_of_particle = "|v|",
            .acceleration = "a",
            .near = "{count} in reach",
            .velocity_scale = "{speed} {unit}",
            .diverged = "The run stopped: its last good state is shown",
            .try_another = "or start again with",
            .picture_saved = "Saved {file}",
            .state_saved = "Saved {file}; F9 comes back to this moment",
            .state_restored = "Back to {file}",
            .nothing_saved = "There is nothing to come back to yet: F5 saves the state",
            .mouse = "Mouse",
            .tool_probe = "probe",
            .tool_pull = "pull",
            .tool_push = "push",
            .tool_add = "add",
            .tool_erase = "erase",
            .tool_obstacle = "wall",
            .tool_grab = "shake",
            .help_title = "Keys and mouse",
            .help_close = "Esc closes this",
            .key_click = "Click",
            .key_wheel = "Wheel",
            .key_middle_drag = "Middle drag",
            .key_control_click = "Ctrl-click on a value",
            .does_pause = "run or pause",
            .does_step = "one step (with Shift: ten)",
            .does_reset = "reset, same seed",
            .does_speed = "faster, slower",
            .does_scene = "previous, next scene",
            .does_colour = "colour by the next quantity",
            .does_lock = "lock the range of the colours",
            .does_grid = "grid of cells",
            .does_neighbour = "previous, next particle",
            .does_vectors = "velocities",
            .does_plots = "energies and error over time",
            .does_panel = "hide or show the panel",
            .does_view = "whole scene",
            .does_save = "save the state",
            .does_restore = "back to the state saved last",
            .does_video = "begin or end a video",
            .does_picture = "save a picture",
            .does_help = "this help",
            .does_quit = "close what is open, then quit",
            .does_select = "look at one particle and its neighbours",
            .does_zoom = "zoom",
            .does_pan = "move the view",
            .does_type = "type it (Enter takes it)",
            .key_right = "Right button",
            .does_right = "pull the liquid (sandbox)",
            .does_language = "en français",
            .does_theme = "light or dark",
            .does_letters = "larger letters",
            .does_sides = "two methods side by side",
            .does_kernel = "kernel at work on one particle",
            .does_back = "one step back (with Shift: ten)",
            .sides =
                {
                    .button = "two sides",
                    .started =
                        "Both sides start anew; the same without a window: ./lab compare {left} {right}",
                    .ended = "The left side goes on alone",
                },
            .inside =
                {
                    .held = "particle {id}, carried by the open end",
                    .mass = "m",
                    .sum = "sum, m a",
                    .in_walls = "{count} in walls",
                    .in_vain = "{count} in vain",
                },
            .kernel =
                {
                    .label = "kernel",
                    .contact_label = "contact",
                    .none = "This scene has no kernel: no particle acts on another",
                    .nobody = "There is no particle to look at",
                    .weight = "Kernel V W",
                    .sum = "Σ V W = {sum}",
                    .slope = "Slope h V W'",
                    .gradient = "h |Σ V ∇W| = {sum}",
                    .fluid = "liquid",
                    .wall = "wall",
                    .contact = "Law of contact",
                    .neighbours = "in reach",
                    .density = "Σ m W = {density} {unit}",
                    .own_density = "ρ = {own}, ρ₀ = {reference}",
                },
            .past =
                {
                    .back_hint = "One step back, with Shift ten: ←",
                    .shown_time = "t = {time} s",
                    .oldest = "t = {time} s is the oldest moment that is kept",
                    .two_sides = "Two sides have no way back: R starts both anew",
                },
            .limits =
                {
                    .sets_dt = "by the {name} limit",
                    .given = "dt is given",
                    .adaptive = "the scheme divides dt as it needs to",
                    .hint = "dt = {dt} s is {share} % of {formula} = {limit} s.\n{kind}",
                    .stable = "Beyond this limit the run diverges.",
                    .accurate = "Beyond this limit the run is less accurate.",
                    .smaller_step = "dt = {dt} s",
                    .step_back = "One step back",
                },
        },

    .lesson =
        {
            .tab_scene = "Scene",
            .tab_lesson = "Lesson",
            .exercise = "Exercise {number} of {count}",
            .run = "Run",
            .steps = "{count} steps",
            .in_terminal = "in a terminal:",
            .changed = "changed by hand: run it again",
            .expected = "expected {value}",
            .show_answer = "Show the answer",
            .hide_answer = "Hide the answer",
        },

    .study =
        {
            .help = "Measures what a method costs and how wrong it is, over a range of settings: a table, a "
                    "summary, and the numbers of the report. A study that was stopped goes on where it was.",
            .help_name = "one or more studies, or all; without a name, this list",
            .help_quick =
                "fewer, coarser and shorter runs, for a first look; kept apart in runs/studies-quick",
            .help_out = "the folder of the tables; runs/studies otherwise",
            .help_force = "measure anew what is there already",
            .list = "Studies:{studies}",
            .done = "{study}: {rows} rows in {file}, {diverged} of them diverged\n",
            .several_builds = "  by {count} builds of the program; --force measures all with this one\n",
            .interrupted =
                "{study} was interrupted; the same command, without --force, goes on where it stopped",
            .other_table =
                "{file} has \"{has}\" where this study would write \"{wanted}\": it was made by another "
                "program or machine. --force measures anew, --out DIR keeps both",
            .damaged_table = "{file} is damaged at \"{line}\"; --force measures anew",
        },
};

static_assert(english == french, "a French sentence does not say what the English one says");

/// The one thing that all threads share of a language.
std::atomic<Language>& in_use() {
  static std::atomic<Language> language{Language::english};
  return language;
}

}  // namespace

Language language() { return in_use(); }
void speak(Language language) { in_use() = language; }

const Words& words() { return language() == Language::french ? french : english; }

}  // namespace clapotis
