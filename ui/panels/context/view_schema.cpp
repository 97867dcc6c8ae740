#include "ui/panels/context/view_schema.h"

#include "app/schema/form_schema.h"
#include "app/schema/import_schema.h"
#include "app/schema/schema_rows.h"

namespace stretch::ui {

namespace {

using app::setting;

app::Schema<ViewportOverlays> shownThings() {
  using V = ViewportOverlays;
  return {
      setting<V>({.name = "controllers", .help = "What the character is posed by."}, &V::controllers),
      setting<V>({.name = "skeleton", .help = "The bones of the character."}, &V::skeleton),
      setting<V>({.name = "wire", .help = "The edges of the mesh."}, &V::wire),
      setting<V>({.name = "joint_names", .help = "The name of each joint."}, &V::jointNames),
      setting<V>({.name = "heat_map", .help = "Stretch of the mesh as colour."}, &V::heatMap),
      setting<V>({.name = "weights", .help = "How much the mesh follows one joint, as colour."}, &V::weights),
      setting<V>(
          {.name = "shade_as",
           .choices = {{"exact", "Normals upright on what is stretched, as bevy, Filament and Blender have "
                                 "them."},
                       {"three", "Normals by the joints' own matrices, as in three.js."},
                       {"godot", "The same: Godot 4 turns them as three.js does."}},
           .help = "Engine whose shading of a stretch is shown."},
          &V::shadeAs),
      setting<V>({.name = "ghosts", .help = "The character at frames before and after."}, &V::ghosts),
      setting<V>({.name = "grid", .help = "The floor."}, &V::grid),
      setting<V>({.name = "reference", .help = "The images of the clip's reference."}, &V::reference),
      setting<V>({.name = "view_cube", .help = "The cube whose sides are looked from."}, &V::viewCube),
      setting<V>({.name = "safe_frame", .help = "The part of the picture that every screen shows."},
                 &V::safeFrame),
      setting<V>({.name = "side_by_side", .help = "The original beside the exaggerated character."},
                 &V::sideBySide),
      setting<V>({.name = "trail_frame_numbers", .help = "Numbers of frames along trails."},
                 &V::trailFrameNumbers),
  };
}

app::Schema<ViewportOverlays> trailDrawing() {
  using V = ViewportOverlays;
  return {
      setting<V>({.name = "trail_thickness",
                  .minimum = 1.0,
                  .maximum = 12.0,
                  .unit = "px",
                  .help = "Of the exaggerated trail, in pixels.",
                  .row = {.section = "trails", .label = "Thickness", .maximum = 8.0, .step = 0.5}},
                 &V::trailThickness),
      setting<V>({.name = "sphere_size",
                  .minimum = 3.0,
                  .maximum = 20.0,
                  .unit = "px",
                  .help = "Size of the control spheres, in pixels.",
                  .row = {.section = "trails", .label = "Spheres", .maximum = 16.0, .step = 0.5}},
                 &V::sphereSize),
      setting<V>({.name = "trail_increment",
                  .minimum = 0.5,
                  .maximum = 4.0,
                  .unit = "frames",
                  .help = "Frames between two points of a drawn trail.",
                  .row = {.section = "trails", .label = "Sampling", .step = 0.5}},
                 &V::trailIncrement),
      setting<V>({.name = "trail_ticks",
                  .help = "Their spacing shows the speed.",
                  .row = {.section = "trails", .label = "Frame ticks"}},
                 &V::trailTicks),
      setting<V>({.name = "only_when_selected",
                  .help = "Draws the trails of the selected limbs and the pinned ones.",
                  .row = {.section = "trails", .label = "Selected only"}},
                 &V::trailsOnlyWhenSelected),
      setting<V>({.name = "trail_window",
                  .help = "Draws trails only around the playhead.",
                  .row = {.section = "trails", .label = "Near frames"}},
                 &V::trailWindow),
      setting<V>({.name = "trail_window_frames",
                  .minimum = 1.0,
                  .maximum = 1000.0,
                  .unit = "frames",
                  .help = "Frames before and after the playhead.",
                  .row = {.section = "trails", .label = "Window", .maximum = 60.0}},
                 &V::trailWindowFrames),
  };
}

app::Schema<ViewportOverlays> ghostDrawing() {
  using V = ViewportOverlays;
  return {
      setting<V>({.name = "ghosts_before",
                  .maximum = 20.0,
                  .help = "Number of ghosts before the playhead.",
                  .row = {.section = "trails", .maximum = 10.0}},
                 &V::ghostsBefore),
      setting<V>({.name = "ghosts_after",
                  .maximum = 20.0,
                  .help = "Number of ghosts after the playhead.",
                  .row = {.section = "trails", .maximum = 10.0}},
                 &V::ghostsAfter),
      setting<V>({.name = "ghost_step",
                  .minimum = 1.0,
                  .maximum = 100.0,
                  .unit = "frames",
                  .help = "Frames between two ghosts.",
                  .row = {.section = "trails", .maximum = 20.0}},
                 &V::ghostStepFrames),
  };
}

app::Schema<app::SequenceView> sequenceLooks() {
  return {
      setting<app::SequenceView>(
          {.name = "look",
           .choices = {{"material", "The materials, textures and colours of the source."},
                       {"compare", "The original in red, the skinned result in green over it."},
                       {"error", "How far each vertex of the result is from the original."},
                       {"thickness", "The shape diameter: how thick the body is under each vertex."},
                       {"segments", "A colour for each bone, mixed by the weights of the vertices."},
                       {"cylinders", "The segments as the elastic model sees them: cylinders that stretch."}},
           .help = "What is shown of a mesh sequence."},
          &app::SequenceView::look),
  };
}

app::Schema<UiState> windowWays() {
  return {
      setting<UiState>({.name = "theme",
                        .choices = {{"dark", "Calm and dark: the character is the brightest thing."},
                                    {"light", "For bright rooms."},
                                    {"contrast", "Black and white with bright edges."}},
                        .help = "Colours of the whole program.",
                        .row = {.section = "settings"}},
                       &UiState::theme),
      setting<UiState>({.name = "scale",
                        .minimum = 0.5,
                        .maximum = 4.0,
                        .help = "Size of text and controls, on top of the screen's own scale.",
                        .row = {.label = "Size"}},
                       &UiState::scale),
      setting<UiState>({.name = "navigation",
                        .choices = {{"maya", "Alt with the left, middle and right button: orbit, pan, zoom."},
                                    {"blender", "Middle button orbits, Shift+middle pans, the wheel zooms."}},
                        .help = "How the mouse turns the view.",
                        .row = {.section = "settings"}},
                       &UiState::navigation),
      setting<UiState>({.name = "exaggerate_at_tip",
                        .help = "Exaggerating moves the playhead to the trail's tip; else a ghost shows the "
                                "pose there.",
                        .row = {.section = "settings", .label = "Go to the tip"}},
                       &UiState::exaggerateAtTip),
      setting<UiState>(
          {.name = "tour_pending", .help = "The tour begins when the bundled punch is opened."},
          [](auto& ui) -> auto& { return ui.tour.pending; }),
      setting<UiState>(
          {.name = "loop", .help = "Playing begins again at the end."},
          [](auto& ui) -> auto& { return ui.time.timeline.loop; }),
      setting<UiState>(
          {.name = "every_frame",
           .help = "Playing shows each frame, however long it takes; else time runs as it is.",
           .row = {.section = "settings", .label = "Every frame"}},
          [](auto& ui) -> auto& { return ui.time.timeline.everyFrame; }),
      setting<UiState>(
          {.name = "on_twos",
           .help = "Playing holds every second frame for two, as cartoons do.",
           .row = {.section = "settings", .label = "On twos"}},
          [](auto& ui) -> auto& { return ui.time.timeline.onTwos; }),
      setting<UiState>(
          {.name = "snap",
           .help = "Playhead and ranges stop at whole frames.",
           .row = {.section = "settings", .label = "Snap to frames"}},
          [](auto& ui) -> auto& { return ui.time.timeline.snapToFrames; }),
  };
}

} // namespace

const app::Schema<ViewportOverlays>& overlaySchema() {
  static const app::Schema<ViewportOverlays> schema =
      app::joined<ViewportOverlays>({shownThings(), trailDrawing(), ghostDrawing()});
  return schema;
}

const app::Schema<app::SequenceView>& sequenceViewSchema() {
  static const app::Schema<app::SequenceView> schema = sequenceLooks();
  return schema;
}

const app::Schema<UiState>& windowSchema() {
  static const app::Schema<UiState> schema =
      app::joined<UiState>({windowWays(),
                            app::partOf<UiState>(
                                app::formSchema(), [](auto& ui) -> auto& { return ui.savedForm; }),
                            app::partOf<UiState>(
                                app::importSchema(), [](auto& ui) -> auto& { return ui.imports; })});
  return schema;
}

} // namespace stretch::ui
