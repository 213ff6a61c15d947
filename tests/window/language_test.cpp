// The window in French: F2 changes the language at once, --lang and the environment choose it.

#include <string>

#include "tests/catch.hpp"
#include "tests/window/desk.hpp"

using clapotis::testing::Desk;

TEST_CASE("F2 changes the language of the window at once, and nothing else", "[window]") {
  Desk desk("language");
  desk.start({STAGE3_PROGRAM, "--paused"});
  desk.await("language english");
  desk.await("step 0 ");
  CHECK(desk.title().starts_with("Stage 3 - grid | cloud"));
  desk.picture("english");
  desk.key("F2");
  desk.await("language french");
  desk.picture("french");
  CHECK_FALSE(desk.seen("started 2"));
  desk.click_control("step");
  desk.await("step 1 ");
  CHECK(desk.title().starts_with("Etape 3 - grille | cloud"));
  desk.key("h");
  desk.await("help on");
  desk.picture("help");
  desk.key("Escape");
  desk.await("help off");
  desk.key("F9");
  CHECK(desk.await("notice ").starts_with("Rien à quoi revenir"));
  desk.key("F2");
  desk.await("language english");
  desk.key("F9");
  CHECK(desk.await("notice ").starts_with("There is nothing to come back to"));
}

TEST_CASE("the window opens in the language of the environment, and what diverged says so in it",
          "[window]") {
  Desk desk("french");
  desk.start({STAGE2_PROGRAM, "pair", "--set", "dt=0.05", "--integrator", "explicit_euler"},
             {{"LC_ALL", "fr_FR.UTF-8"}});
  desk.await("language french");
  desk.await("diverged step ");
  desk.picture("diverged");
  desk.key("F2");
  desk.await("language english");
  desk.picture("diverged_english");
}
