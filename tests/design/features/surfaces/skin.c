#include "design/agree.h"

#include <batten/skin.h>
#include <batten/sweep.h>

/* Skins and sweeps are the calls behind them, with each option in its place. */

static const char sections[] =
    "  e: {points: [[0, 0, 0], [0, 1, 0.2], [0, 2, 0.2], [0, 3, 0]]}\n"
    "  f: {points: [[1, 0, 0.1], [1, 1.6, 0.3], [1, 3, 0]]}\n"
    "  g: {points: [[2, 0, 0.1], [2, 0.6, 0.3], [2, 2, 0.5], [2, 3, 0]]}\n"
    "  h: {points: [[3, 0, 0.2], [3, 1, 0.4], [3, 2, 0.5], [3, 3, 0]]}\n"
    "  s1: {interpolate: e}\n  s2: {interpolate: f}\n  s3: {interpolate: g}\n  s4: {interpolate: h}\n"
    "  bend: {arc: 20, angle: 40 deg, axis: y}\n  small: {arc: 1, angle: 120 deg}\n"
    "  wide: {arc: 2, angle: 120 deg}\n  guide: {move: bend, by: [0, 3, 0]}\n"
    "  profile: {polyline: [[1, 0], [2, 0.5]]}\n";

static batten_status skin(const batten_design *design,
                          const batten_surface_skin_options *options, agree_surface *made)
{
    static const char *const names[] = {"s1", "s2", "s3", "s4"};
    const batten_curve *curves[4];
    batten_surface_skin_report report = {0};
    for (int i = 0; i < 4; i++)
        curves[i] = agree_input(design, names[i]);
    const batten_status status = batten_surface_skin((batten_curve_row){4, curves}, options,
                                                     NULL, NULL, &report, &made->surface);
    made->error = report.error;
    return status;
}

static batten_surface_skin_options aligned(void)
{
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.align = options.untwist = true;
    return options;
}

static batten_status skin_as_it_is(const batten_design *design, agree_surface *made)
{
    const batten_surface_skin_options options = aligned();
    return skin(design, &options, made);
}

static batten_status skin_with_options(const batten_design *design, agree_surface *made)
{
    batten_surface_skin_options options = aligned();
    options.degree = 2;
    options.tolerance = 0.01;
    options.parameters = BATTEN_CHORD;
    options.match = BATTEN_MATCH_ARC_LENGTH;
    return skin(design, &options, made);
}

static batten_status skin_with_ends(const batten_design *design, agree_surface *made)
{
    batten_surface_skin_options options = aligned();
    options.start = (batten_end){BATTEN_END_CLAMPED, {1, 0, 2}};
    options.end = (batten_end){BATTEN_END_SECOND, {0, 1, 1}};
    options.creases = BATTEN_CREASES_KEEP;
    return skin(design, &options, made);
}

/* Marks at shares of the parameter of each section, which then stay as they run. */
static batten_status skin_with_marks(const batten_design *design, agree_surface *made)
{
    static const char *const names[] = {"s1", "s2", "s3", "s4"};
    static const double shares[] = {0.3, 0.6, 0.4, 0.7, 0.3, 0.5, 0.2, 0.6};
    double marks[8];
    for (int i = 0; i < 8; i++)
        marks[i] = shares[i] * batten_curve_domain(agree_input(design, names[i / 2])).b;
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.align = options.untwist = false;
    options.tolerance = 0.01;
    options.match = BATTEN_MATCH_MARKS;
    options.mark_count = 2;
    options.marks = marks;
    return skin(design, &options, made);
}

TEST(skins_are_those_of_their_calls)
{
    static const agree_surface_row rows[] = {
        {"{skin: [s1, s2, s3, s4]}", skin_as_it_is},
        {"{skin: [s1, s2, s3, s4], degree: 2, within: 0.01, parameters: chord, match: arc-length}",
         skin_with_options},
        {"{skin: [s1, s2, s3, s4], start: clamped, start-vector: [1, 0, 2], end: second, end-vector: "
         "[0, 1, 1], creases: keep}",
         skin_with_ends},
        {"{skin: [s1, s2, s3, s4], within: 0.01, match: marks, marks: [0.3, 0.6, 0.4, 0.7, 0.3, 0.5, "
         "0.2, 0.6]}",
         skin_with_marks},
    };
    AGREE_SURFACES(sections, rows);
}

static batten_status sweep(const batten_design *design,
                           const batten_surface_sweep_options *options, int count,
                           agree_surface *made)
{
    const batten_curve *curves[3] = {agree_input(design, "small")};
    batten_surface_sweep_report report = {0};
    if (count > 1)
        curves[1] = agree_input(design, "wide");
    curves[2] = curves[0];
    const batten_status status =
        batten_surface_sweep((batten_curve_row){count, curves}, agree_input(design, "bend"),
                             options, NULL, &report, &made->surface);
    made->error = report.error;
    return status;
}

static batten_surface_sweep_options within(double tolerance)
{
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    options.tolerance = tolerance;
    options.align = true;
    return options;
}

static batten_status sweep_as_it_is(const batten_design *design, agree_surface *made)
{
    const batten_surface_sweep_options options = within(0.01);
    return sweep(design, &options, 1, made);
}

static batten_status sweep_between(const batten_design *design, agree_surface *made)
{
    static const double at[] = {0, 0.3, 1};
    batten_surface_sweep_options options = within(0.01);
    options.degree = 5;
    options.at = at;
    options.align = false;
    return sweep(design, &options, 3, made);
}

static batten_status sweep_upright(const batten_design *design, agree_surface *made)
{
    const batten_vec3 up = {0, 1, 0};
    batten_surface_sweep_options options = within(0.01);
    options.up = &up;
    return sweep(design, &options, 1, made);
}

static batten_status sweep_fixed(const batten_design *design, agree_surface *made)
{
    batten_surface_sweep_options options = within(0.01);
    options.frames = BATTEN_FRAME_FIXED;
    options.x = (batten_vec3){0, 1, 0};
    return sweep(design, &options, 1, made);
}

static batten_status sweep_guided(const batten_design *design, agree_surface *made)
{
    batten_surface_sweep_options options = within(0.01);
    options.guide = agree_input(design, "guide");
    return sweep(design, &options, 1, made);
}

static batten_status two_rails(const batten_design *design, agree_surface *made)
{
    batten_surface_two_rails_options options = batten_surface_two_rails_defaults();
    batten_surface_sweep_report report = {0};
    options.tolerance = 0.01;
    options.match = BATTEN_RAILS_BY_LENGTH;
    options.across = (batten_vec3){0, 0, 1};
    options.fixed_height = true;
    const batten_curve *const rails[2] = {agree_input(design, "bend"),
                                          agree_input(design, "guide")};
    const batten_status status = batten_surface_two_rails(
        agree_input(design, "small"), rails, &options, NULL, &report, &made->surface);
    made->error = report.error;
    return status;
}

TEST(sweeps_are_those_of_their_calls)
{
    static const agree_surface_row rows[] = {
        {"{sweep: small, path: bend, within: 0.01}", sweep_as_it_is},
        {"{sweep: [small, wide, small], path: bend, within: 0.01, degree: 5, at: [0, 0.3, 1], align: no}",
         sweep_between},
        {"{sweep: small, path: bend, within: 0.01, up: [0, 1, 0]}", sweep_upright},
        {"{sweep: small, path: bend, within: 0.01, frames: fixed, x-axis: [0, 1, 0]}",
         sweep_fixed},
        {"{sweep: small, path: bend, within: 0.01, guide: guide}", sweep_guided},
        {"{two-rails: [bend, guide], section: small, within: 0.01, match: length, across: [0, 0, 1], "
         "height: fixed}",
         two_rails},
    };
    AGREE_SURFACES(sections, rows);
}
