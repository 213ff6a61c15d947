#pragma once

#include "common/words.hpp"

namespace clapotis {

/// The French table, beside the English one in words.cpp. A space before : ; ? ! % and inside guillemets is a
/// no-break space, U+00A0.
inline constexpr Words french{
    .unknown_parameter = "la scène n'a pas de paramètre {name} ; elle a : {known}",
    .unknown_name = "il n'y a pas {kind} {name} ; il y a : {known}",
    .did_you_mean = " ; vouliez-vous dire {name} ?",
    .value_out_of_range = "{name} = {value}{unit} est hors limites : il faut {name} {allowed}",
    .not_a_number = "{name} = {value} n'est pas un nombre fini : il faut {name} {allowed}",
    .not_an_integer = "{name} = {value} n'est pas un nombre entier : il faut {name} {allowed}",
    .not_a_choice = "{name} = {value} n'est pas un choix possible : {allowed}",
    .comma_for_dot =
        "{name} = {value} n'est pas un nombre (les décimales s'écrivent avec un point, 0.5) : il faut {name} "
        "{allowed}",
    .needs_restart =
        "{name} ne peut pas changer pendant que la scène tourne : il prend effet quand elle recommence",
    .derived_parameter = "{name} se déduit d'autres paramètres et ne se choisit pas",
    .too_many_discs =
        "particles = {count} : autant de disques de rayon {radius} {unit} ne tiennent pas dans la boîte ; "
        "{most} au plus",
    .box_too_small =
        "radius = {radius} {unit} est trop grand : il faut au disque une boîte plus large que 2 radius, et "
        "non {side} {unit}",
    .outside_box =
        "{name} = {value} {unit} est hors de la boîte : il faut {name} entre {low} et {high} {unit}",
    .no_time_step =
        "dt = auto ne trouve aucune limite dont prendre une part (rien ne bouge, rien ne tombe) : donnez "
        "dt en secondes",
    .vanishing_time_step =
        "dt = auto donne {dt} s d'après la limite {limit} {formula} : une vitesse, une masse ou une raideur "
        "est démesurée",
    .too_many_steps =
        "until = {until} s est à {count} pas de dt = {dt} s, plus que les {most} que l'on peut compter : "
        "augmentez dt ou diminuez until",
    .other_unit = "{name} = {value} est en {given}, mais {name} est en {unit} dans cette scène",
    .from_place = "{place} : {sentence}",
    .threads_out_of_range = "threads = {value} est hors limites : il faut threads au moins égal à 1",
    .spacing_too_large = "spacing = {value} ne laisse pas de place à une seule particule",
    .spacing_too_small = "spacing = {value} donnerait plus de {most} particules",
    .no_room_for_drop =
        "pas de place pour une goutte en ({x}, {y}) {unit} : du liquide et des parois l'occupent",
    .obstacle_over_liquid =
        "il y a du liquide en ({x}, {y}) {unit} : effacez-le d'abord, ou dessinez là où il n'y en a pas",
    .no_sound_speed =
        "sound_speed vaut 10 fois la plus grande vitesse de l'écoulement, mais rien ne bouge et rien ne "
        "tombe : donnez-la en {unit}/s, par exemple --set sound_speed=10",
    .entry_twice = "{name} = {value} contient deux fois {entry}",
    .integrator_of_particles =
        "{name} ne fait pas avancer la masse volumique d'un liquide : ici, le schéma est l'un de {known}",
    .any_finite = "fini",
    .range_above = "> {low}",
    .range_at_least = ">= {low}",
    .range_at_most = "<= {high}",
    .range_between = "entre {low} et {high}",
    .or_auto = ", ou auto",
    .each_or_none = " pour chacun, séparés par des virgules, ou none",
    .none = "aucun choix",
    .diverged = "divergence au pas {step}, t = {time} s, particule {particle} : {cause}",
    .diverged_speed =
        "sa vitesse {speed} {unit} dépasse tout ce que permet l'énergie de la scène ({bound} {unit})",
    .diverged_nan = "sa position, sa vitesse ou sa masse volumique n'est plus un nombre",
    .cause_limit = " ; dt = {dt} s vaut {ratio} fois la limite {limit} {formula}",
    .cause_scheme =
        " ; {integrator} n'est pas stable ici avec dt = {dt} s : prenez un dt plus petit ou un autre schéma",
    .beyond_limit =
        "dt = {dt} s vaut {ratio} fois la limite {limit} {formula} : le calcul va sans doute diverger",
    .warn_coincident =
        "deux particules étaient au même point ({count} fois) ; elles ont été écartées dans une direction "
        "tirée de leurs numéros",
    .warn_coincident_fluid =
        "deux particules du liquide étaient au même point ({count} fois) ; aucune pression ne les sépare",
    .warn_folded =
        "une particule a rencontré les parois plus souvent en un pas que l'on n'en suit ({count} fois) ; "
        "ses réflexions ont été comptées à la place",
    .unknown_option = "il n'y a pas d'option {option}, --help les énumère toutes{hint}",
    .option_is_parameter = "il n'y a pas d'option {option} ; pour le paramètre, écrivez --set {name}=VALEUR",
    .option_needs_value = "{option} demande une valeur",
    .option_takes_no_value = "{option} ne prend pas de valeur",
    .one_scene_at_a_time = "une scène à la fois : {first}, ou {second} ?",
    .set_without_equals = "--set {text} n'a pas de valeur : écrivez --set NOM=VALEUR",
    .empty_value = "{option} demande un nom, pas un mot vide",
    .no_seed = "la scène {scene} ne laisse rien au hasard : --seed n'a pas de sens ici",
    .environment_ignored = "{variable} est ignorée : la scène {scene} n'a pas ce paramètre{hint}",
    .needs_headless = "{option} est pour un calcul sans fenêtre : ajoutez --headless",
    .needs_window = "{option} est pour la fenêtre ; sans elle, ./lab compare calcule deux scènes côte à côte",
    .beside_without_equals = "--beside {text} n'a pas de valeur : écrivez --beside NOM=VALEUR",
    .picture_extension = "--picture {file} : le nom doit finir par .png, .svg ou .pdf",
    .config_unknown_key = "{file} : il n'y a pas de clé {key}{hint}",
    .config_wrong_kind = "{file} : {key} ne peut pas être {value}",
    .config_no_value = "{file} : {key} n'a pas de valeur",
    .config_key_twice = "{file} : {key} est donné deux fois",
    .config_not_json = "{file}, ligne {line} : ce n'est pas du JSON : {reason}",
    .config_other_stage = "{file} est de {other}, et ce programme est {stage}",
    .config_resumed = "{file} vient d'un calcul repris d'un état sauvegardé ; celui-ci part du début",
    .video_extension = "--video {file} : le nom doit finir par .mp4",
    .option_without = "{option} n'a pas de sens sans {other}",
    .state_no_state =
        "{file} n'est pas un état sauvegardé : --resume prend ce que --save, ou F5 dans la fenêtre, a écrit",
    .state_other_format =
        "{file} est un état au format {format}, et ce programme lit le format {own} : reprenez-le avec le "
        "programme qui l'a écrit",
    .state_cut_short =
        "{file} est tronqué, {bytes} octets sur {whole} : recopiez-le d'où il a été sauvegardé, ou partez du "
        "début",
    .state_damaged =
        "{file} est abîmé : ses octets ne sont pas ceux qui ont été sauvegardés ; recopiez-le d'où il a été "
        "sauvegardé, ou partez du début",
    .state_other_version =
        "{file} a été sauvegardé par {other}, et ceci est {own}, qui ne donne pas forcément les mêmes bits : "
        "reprenez-le avec cette version-là, ou partez du début",
    .state_other_width =
        "{file} a été sauvegardé par un programme à vecteurs de {other}, et celui-ci a des vecteurs de "
        "{own}, "
        "qui donnent d'autres bits : reprenez-le avec une version compilée pour ce processeur-là, ou partez "
        "du début",
    .state_other_build =
        "{file} a été sauvegardé par une autre compilation de ce programme, qui ne donne pas forcément les "
        "mêmes bits : reprenez-le avec elle, ou partez du début",
    .state_other_scene =
        "{file} est de la scène {other}, pas de {scene} : omettez la scène, ou lancez {scene} sans --resume",
    .state_contradiction =
        "{name} = {value} contredit {file}, où {name} = {other}, et ne peut pas changer pendant que la scène "
        "tourne : omettez-le, ou partez du début sans --resume",
    .state_at_end = "{file} en est déjà à t = {time} s, pas {steps} : {option} doit être au-delà",
    .resume_and_config =
        "--resume et --config : un calcul repris tient ses valeurs de l'état ; donnez avec --set ce qui doit "
        "changer",
    .no_encoder =
        "pas de ffmpeg pour faire {file} : installez-le (sous Debian et Ubuntu : apt install ffmpeg), ou "
        "renoncez à la vidéo",
    .encoder_failed = "ffmpeg a abandonné {file} : {reason}",
    .encoder_ended = "il s'est terminé avec le code {code}",
    .cannot_read = "impossible de lire {file} : {reason}",
    .cannot_write = "impossible d'écrire {file} : {reason}",
    .folder_exists =
        "{folder} existe et n'est pas vide : choisissez un autre --out, ou --force pour remplacer un calcul "
        "précédent",
    .not_a_folder = "{folder} existe et n'est pas un dossier",
    .not_a_run_folder =
        "{folder} ne contient pas de {mark}, ce n'est donc pas le dossier d'un calcul : --force n'y touche "
        "pas",
    .no_display = "pas d'écran où ouvrir une fenêtre : lancez {name} --headless, ou définissez DISPLAY",
    .interrupted = "interrompu ; ce qui a été calculé est gardé",
    .no_memory = "mémoire insuffisante : prenez moins de particules",
    .own_fault = "une erreur du programme lui-même : {what}",
    .standard_output = "la sortie standard",
    .no_greek_letters =
        "DejaVuSans.ttf introuvable, les lettres grecques manqueront (installez fonts-dejavu-core)",
    .no_letters = "pas de texte dans l'image sans DejaVuSans.ttf (installez fonts-dejavu-core)",
    .progress = "{percent} %, {what}, encore {left}",
    .summary_run =
        "{folder} : {reason} à t = {time} s\n"
        "  pas       {steps} de {dt} s avec {integrator}, N = {particles}\n",
    .summary_cost =
        "  coût      {cpu} de processeur (x{speed} temps réel), {step} par pas, {rate} mises à jour de "
        "particules par seconde\n",
    .summary_energy =
        "  énergie   mécanique de {start} à {end} {unit} ; dérive de la totale, rapportée au départ : "
        "{drift}\n",
    .summary_error = "  écart     {measure} = {error}{unit} à la fin, {largest} au plus ({reference})\n",
    .summary_saved = "  état      {file} : pas {step}, t = {time} s, d'où --resume repart\n",
    .summary_warning = "  attention {warning}\n",
    .stopped_done = "terminé",
    .stopped_interrupted = "interrompu",
    .stopped_diverged = "divergence ; ceci est le dernier bon état,",
    .column_name = "nom",
    .column_symbol = "symbole",
    .column_unit = "unité",
    .column_default = "défaut",
    .column_range = "valeurs",
    .column_change = "effet",
    .column_meaning = "sens",
    .plot_energies = "Énergies",
    .plot_error = "Écart à la référence ({reference})",
    .kinetic = "cinétique",
    .potential = "potentielle",
    .elastic = "élastique",
    .internal = "compression",
    .mechanical = "mécanique",
    .total = "avec les pertes",
    .measured_points = "u des particules",
    .compare_side = "{side} n'est pas de la forme ÉTAPE/SCÈNE[:NOM=VALEUR,...]",
    .compare_assignment = "{side} : {text} n'est pas de la forme NOM=VALEUR",
    .compare_two_sides = "une comparaison prend deux ÉTAPE/SCÈNE[:NOM=VALEUR,...], et non {count}",
    .compare_two_ends = "--until et --steps : une comparaison finit à l'un des deux",
    .compare_units = "les côtés mesurent en {left} et en {right} : on ne peut pas les comparer",
    .compare_other_particles =
        "les deux côtés n'ont pas les mêmes particules, {left} et {right} : les erreurs, les énergies et le "
        "coût "
        "sont comparés, les positions ne le sont pas",
    .compare_other_start =
        "les côtés ne commencent pas pareil : à t = 0, des particules sont distantes de {largest} {unit}",
    .compare_title = "{folder} : comparaison jusqu'à t = {time} s\n",
    .compare_side_line =
        "{name} {side}\n"
        "  pas       {steps} de {dt} s avec {integrator}, {evaluations} évaluations des forces\n"
        "  coût      {cpu} s de processeur, {cost} ms par seconde simulée, {step} ms par pas\n"
        "  énergie   dérive de la totale, rapportée au départ : {drift}\n",
    .compare_left = "gauche",
    .compare_right = "droite",
    .compare_end =
        "différence à la fin :  {largest} {unit} au plus ({share} % de la diagonale de la boîte), moyenne "
        "quadratique {rms} {unit}\n",
    .compare_largest =
        "différence maximale :  {largest} {unit} ({share} %), à t = {time} s, particule {particle}\n",
    .compare_ratio = "droite sur gauche :    {cpu} en temps de processeur, {step} par pas\n",
    .compare_cost = "CPU {cost}   {evaluations} évaluations   énergie {drift}",
    .compare_plot = "Différence",
    .compare_distance = "|r gauche - r droite|",
    .compare_curve_largest = "maximale",
    .compare_curve_rms = "quadratique",
    .help_compare =
        "Calcule deux scènes depuis le même départ sur une horloge commune, et dit de combien elles "
        "s'écartent. Avec le même pas de temps, elles sont comparées après chaque pas ; sinon, à des "
        "instants communs, sans que rien ne change à leurs trajectoires.",
    .help_side = "ÉTAPE/SCÈNE[:NOM=VALEUR,...] ; NOM est un paramètre, integrator ou threads",
    .help_compare_steps = "s'arrêter après tant de pas du côté gauche",
    .help_compare_every = "temps simulé entre deux lignes de compare.csv [s]",
    .help_compare_out = "le dossier à laisser ; sinon runs/compare-DATE",
    .help_compare_json = "écrire compare.json, pour un programme",
    .help_scene = "la scène, par son nom ; sinon la première",
    .help_headless = "sans fenêtre ; laisse un dossier de résultats et écrit un résumé",
    .help_until = "s'arrêter à ce temps simulé [s] ; 5 si ni --until ni --steps n'est donné",
    .help_steps = "s'arrêter après tant de pas",
    .help_set = "un paramètre ; peut se répéter, la dernière valeur d'un même nom compte",
    .help_config = "des valeurs d'un fichier, ou du run.json d'un calcul précédent, qui est alors refait",
    .help_print_config = "écrire toutes les valeurs, leur unité et leur provenance, et finir",
    .help_preset =
        "une variante de la scène, jeu de valeurs livré avec elle : voir --list presets ; --set l'emporte",
    .help_colour_by = "ce que montrent les couleurs des images : speed, pressure, vorticity, ... ou plain",
    .help_integrator = "le schéma d'intégration : voir --list integrators",
    .help_seed = "raccourci de --set seed=N",
    .help_threads = "1 à 1024 ; les résultats n'en dépendent pas",
    .help_out = "le dossier des résultats ; sinon runs/ÉTAPE-SCÈNE-DATE",
    .help_force = "remplacer le calcul précédent dans --out",
    .help_every =
        "temps simulé entre deux lignes de series.csv [s] ; sinon chaque pas d'un calcul court, environ 500 "
        "lignes d'un long",
    .help_frames = "écrire aussi toutes les particules dans frames/NNNN.csv, à cet intervalle [s]",
    .help_vtk =
        "écrire aussi toutes les particules dans vtk/NNNN.vtu, à cet intervalle [s], et vtk.pvd, que "
        "ParaView ouvre",
    .help_picture = "écrire aussi une image ici, .png, .svg ou .pdf",
    .help_video = "faire aussi un film, ce qui demande ffmpeg",
    .help_video_every =
        "temps simulé entre deux de ses images, dont 30 durent une seconde [s] ; sinon en temps réel, mais "
        "de 5 à 60 secondes",
    .help_save =
        "sauvegarder l'état à la fin, d'où --resume repart ; le dernier pas, que --until a modifié, n'y est "
        "pas",
    .help_resume =
        "reprendre d'un état sauvegardé, au bit près ; --until et --steps comptent depuis le tout début, et "
        "les paramètres modifiables en marche peuvent changer",
    .help_list =
        "écrire les scènes, paramètres, schémas ou noyaux (scenes, parameters, integrators, kernels), "
        "et finir",
    .help_json = "écrire run.json (ou la liste), pour un programme",
    .help_quiet = "n'écrire que les erreurs",
    .help_paused = "ouvrir la fenêtre à l'arrêt",
    .help_beside =
        "ouvrir la fenêtre avec la scène deux fois, côte à côte ; le côté droit a cette valeur, par exemple "
        "integrator=rk4",
    .help_scale = "taille des lettres de la fenêtre, 0.25 à 8",
    .help_theme = "couleurs de la fenêtre, des images et des films : light (clair) ou dark (sombre)",
    .help_lang = "en ou fr ; sinon selon LC_ALL, LC_MESSAGES ou LANG",
    .help_version = "écrire la version, et finir",
    .help_help = "écrire ceci, et finir",
    .help_epilogue =
        "Scènes : {scenes}\n\n"
        "Une valeur vient de --set et des autres options, ou sinon de l'environnement (CLAPOTIS_GRAVITY=3),\n"
        "ou sinon du fichier de --config, ou sinon de la scène. Les décimales s'écrivent avec un point.\n\n"
        "Codes de retour : 0 terminé, 1 une vérification a échoué, 2 usage ou paramètre incorrect, 3 pas "
        "d'écran,\n4 entrée ou sortie, 5 divergence, 130 interrompu (ce qui a été calculé est gardé).\n\n"
        "Exemple : {stage} {scene} --headless --until 2 --set gravity=3 --out runs/lune",
    .help_usage = "Utilisation",
    .help_arguments = "Arguments",

    .window =
        {
            .run = "Lancer",
            .pause = "Pause",
            .step = "Un pas",
            .reset = "Au début",
            .speed = "vitesse",
            .slower_than_asked = "tourne à x{factor}",
            .scene = "scène",
            .preset = "variante",
            .integrator = "schéma",
            .live = "Paramètres (en marche)",
            .restart = "Départ (relance la scène)",
            .defaults = "Par défaut",
            .automatic = "auto",
            .type_hint = "{meaning}\n{allowed}\nCtrl-clic ou clic droit pour taper une valeur",
            .time_step = "Pas de temps",
            .close_to_instability = "proche de la limite de stabilité",
            .beyond_stability = "au-delà de la limite de stabilité",
            .view = "Affichage",
            .colour_by = "couleur",
            .lock_range = "figer",
            .grid = "grille",
            .vectors = "vitesses",
            .plots = "énergies",
            .letters = "lettres",
            .dark = "sombre",
            .cost = "Coût",
            .particles = "N = {count}",
            .step_cost = "{time} par pas",
            .real_time = "x{factor} temps réel",
            .picture = "image",
            .video = "vidéo",
            .stop_video = "arrêt",
            .table = "CSV",
            .grid_file = "VTK",
            .save = "garder",
            .restore = "revenir",
            .recording = "enregistrement, {seconds} s",
            .pairs_near = "{count} paires à portée",
            .pairs_tested = "sur {count} testées",
            .frames = "{count} images/s",
            .frame_cost = "{time} pour en peindre une",
            .particle = "particule {id}",
            .position = "r",
            .velocity = "v",
            .speed_of_particle = "|v|",
            .acceleration = "a",
            .near = "{count} à portée",
            .velocity_scale = "{speed} {unit}",
            .diverged = "Le calcul s'est arrêté : voici son dernier bon état",
            .try_another = "ou recommencer avec",
            .picture_saved = "{file} enregistré",
            .state_saved = "{file} enregistré ; F9 revient à cet instant",
            .state_restored = "Retour à {file}",
            .nothing_saved = "Rien à quoi revenir encore : F5 sauvegarde l'état",
            .mouse = "Souris",
            .tool_probe = "sonder",
            .tool_pull = "attirer",
            .tool_push = "pousser",
            .tool_add = "ajouter",
            .tool_erase = "effacer",
            .tool_obstacle = "paroi",
            .tool_grab = "secouer",
            .help_title = "Clavier et souris",
            .help_close = "Échap ferme cette aide",
            .key_click = "Clic",
            .key_wheel = "Molette",
            .key_middle_drag = "Glisser, bouton du milieu",
            .key_control_click = "Ctrl-clic sur une valeur",
            .does_pause = "lancer ou mettre en pause",
            .does_step = "un pas (avec Maj : dix)",
            .does_reset = "revenir au début, même graine",
            .does_speed = "plus vite, moins vite",
            .does_scene = "scène précédente, suivante",
            .does_colour = "colorer selon la grandeur suivante",
            .does_lock = "figer l'échelle des couleurs",
            .does_grid = "grille des cellules",
            .does_neighbour = "particule précédente, suivante",
            .does_vectors = "vecteurs vitesse",
            .does_plots = "énergies et écart au cours du temps",
            .does_panel = "cacher ou montrer le panneau",
            .does_view = "toute la scène",
            .does_save = "sauvegarder l'état",
            .does_restore = "revenir au dernier état sauvegardé",
            .does_video = "commencer ou finir une vidéo",
            .does_picture = "enregistrer une image",
            .does_help = "cette aide",
            .does_quit = "fermer ce qui est ouvert, puis quitter",
            .does_select = "observer une particule et ses voisines",
            .does_zoom = "zoom",
            .does_pan = "déplacer la vue",
            .does_type = "la taper (Entrée la valide)",
            .key_right = "Bouton droit",
            .does_right = "attirer le liquide (sandbox)",
            .does_language = "in English",
            .does_theme = "clair ou sombre",
            .does_letters = "lettres plus grandes",
            .does_sides = "deux méthodes côte à côte",
            .does_kernel = "le noyau à l'œuvre sur une particule",
            .does_back = "un pas en arrière (avec Maj : dix)",
            .sides =
                {
                    .button = "2 côtés",
                    .started = "Les deux côtés repartent du début ; la même chose sans fenêtre : ./lab "
                               "compare {left} {right}",
                    .ended = "Le côté gauche continue seul",
                },
            .inside =
                {
                    .held = "particule {id}, entraînée par l'entrée ou la sortie",
                    .mass = "m",
                    .sum = "somme, m a",
                    .in_walls = "{count} dans les parois",
                    .in_vain = "{count} en vain",
                },
            .kernel =
                {
                    .label = "noyau",
                    .contact_label = "contact",
                    .none = "Cette scène n'a pas de noyau : aucune particule n'agit sur une autre",
                    .nobody = "Il n'y a aucune particule à regarder",
                    .weight = "Noyau V W",
                    .sum = "Σ V W = {sum}",
                    .slope = "Pente h V W'",
                    .gradient = "h |Σ V ∇W| = {sum}",
                    .fluid = "liquide",
                    .wall = "paroi",
                    .contact = "Loi de contact",
                    .neighbours = "à portée",
                    .density = "Σ m W = {density} {unit}",
                    .own_density = "ρ = {own}, ρ₀ = {reference}",
                },
            .past =
                {
                    .back_hint = "Un pas en arrière, dix avec Maj : ←",
                    .shown_time = "t = {time} s",
                    .oldest = "t = {time} s est le plus ancien instant conservé",
                    .two_sides = "Avec deux côtés on ne revient pas en arrière : R recommence les deux",
                },
            .limits =
                {
                    .sets_dt = "par la limite {name}",
                    .given = "dt imposé",
                    .adaptive = "le schéma subdivise dt si nécessaire",
                    .hint = "dt = {dt} s, soit {share} % de {formula} = {limit} s.\n{kind}",
                    .stable = "Au-delà de cette limite, le calcul diverge.",
                    .accurate = "Au-delà de cette limite, le calcul est moins précis.",
                    .smaller_step = "dt = {dt} s",
                    .step_back = "Un pas en arrière",
                },
        },

    .lesson =
        {
            .tab_scene = "Scène",
            .tab_lesson = "Exercices",
            .exercise = "Exercice {number} sur {count}",
            .run = "Lancer",
            .steps = "{count} pas",
            .in_terminal = "dans un terminal :",
            .changed = "modifié à la main : à relancer",
            .expected = "attendu {value}",
            .show_answer = "Montrer la réponse",
            .hide_answer = "Cacher la réponse",
        },

    .study =
        {
            .help = "Mesure ce que coûte une méthode et de combien elle se trompe, pour une gamme de "
                    "réglages : une "
                    "table, un résumé et les nombres du rapport. Une étude arrêtée reprend où elle en était.",
            .help_name = "une ou plusieurs études, ou all pour toutes ; sans nom, cette liste",
            .help_quick = "moins de calculs, plus grossiers et plus courts, pour un premier regard ; rangés "
                          "à part dans "
                          "runs/studies-quick",
            .help_out = "le dossier des tables ; sinon runs/studies",
            .help_force = "mesure à nouveau ce qui existe déjà",
            .list = "Études :{studies}",
            .done = "{study} : {rows} lignes dans {file}, dont {diverged} divergées\n",
            .several_builds =
                "  par {count} versions compilées du programme ; --force mesure tout avec celle-ci\n",
            .interrupted =
                "{study} a été interrompue ; la même commande, sans --force, reprend où elle s'est arrêtée",
            .other_table =
                "{file} contient « {has} » là où cette étude écrirait « {wanted} » : un autre programme ou "
                "une autre machine l'a faite. --force mesure à nouveau, --out DOSSIER garde les deux",
            .damaged_table = "{file} est endommagé à « {line} » ; --force mesure à nouveau",
        },
};

}  // namespace clapotis
