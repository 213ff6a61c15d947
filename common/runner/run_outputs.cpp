#include "common/runner/run_outputs.hpp"

#include "common/runner/atomic_file.hpp"
#include "common/runner/describe.hpp"
#include "common/runner/particle_table.hpp"
#include "common/runner/save_sheet.hpp"

namespace clapotis {

void check_files(const Options& options) {
  for (const auto* file : {&options.picture, &options.video, &options.save})
    if (*file) check_place(**file);
  if (options.video) require_encoder(*options.video);
}

RunOutputs::RunOutputs(const Stage& stage, const Options& options, Simulation& simulation, double length)
    : stage_(stage),
      options_(options),
      simulation_(simulation),
      colour_by_(colouring(simulation, options.colour_by)),
      folder_(options.out ? RunFolder(*options.out, options.force, files_of_run)
                          : RunFolder::by_date(stage.name + "-" + options.scene.value)),
      rows_(options.every.value_or(usual_interval(simulation.dt(), length, simulation.particles().size()))),
      frames_(options.frames.value_or(0)),
      vtk_times_(options.vtk.value_or(0)),
      series_(folder_.file("series.csv"), simulation) {
  if (options.video)
    film_.begin(*options.video, simulation.time(), options.video_every.value_or(usual_film_interval(length)));
  record();
  if (options_.frames) write_frame();
  if (options_.vtk) write_vtk();
  if (options_.video) shoot();
}

bool RunOutputs::due() const {
  const double time = simulation_.time(), dt = simulation_.dt();
  return rows_.due(time, dt) || (options_.frames && frames_.due(time, dt)) ||
         (options_.vtk && vtk_times_.due(time, dt)) || film_.due(time, dt);
}

void RunOutputs::write_due() {
  const double time = simulation_.time(), dt = simulation_.dt();
  if (rows_.due(time, dt)) record();
  if (options_.frames && frames_.due(time, dt)) write_frame();
  if (options_.vtk && vtk_times_.due(time, dt)) write_vtk();
  if (film_.due(time, dt)) shoot();
}

void RunOutputs::finish(const Film::Told& painted) {
  if (last_recorded_ != simulation_.steps()) record();
  series_.close();
  if (options_.vtk) vtk_.close();
  film_.finish(painted);
}

void RunOutputs::record() {
  rows_.serve(simulation_.time(), simulation_.dt());
  const Moment moment(simulation_);
  series_.add(moment);
  history_.add(simulation_, moment.energy);
  last_recorded_ = simulation_.steps();
}

void RunOutputs::write_frame() {
  frames_.serve(simulation_.time(), simulation_.dt());
  write_particles(folder_.numbered("frames", frame_count_++, ".csv"), simulation_);
}

void RunOutputs::write_vtk() {
  vtk_times_.serve(simulation_.time(), simulation_.dt());
  vtk_.add(simulation_);
}

void RunOutputs::shoot() {
  film_.add(picture(true), plots(history_, simulation_), simulation_.time(), simulation_.dt());
}

/// Speeds of discs have the range of the whole run, since all of them may rest at its end.
Picture RunOutputs::picture(bool own_range) const {
  Viewpoint viewpoint;
  viewpoint.colour_by = colour_by_;
  const bool by_speed = viewpoint.colour_by == "speed" && !simulation_.setup().fluid;
  if (!own_range && by_speed && history_.largest_speed() > 0) viewpoint.range = {0, history_.largest_speed()};
  return describe(stage_.title, simulation_, viewpoint);
}

void RunOutputs::write_pictures() const {
  const auto last = picture(false);
  const auto curves = plots(history_, simulation_);
  save_sheet(folder_.file("picture.png"), last, curves);
  if (options_.picture) save_sheet(*options_.picture, last, curves);
}

}  // namespace clapotis
