/* Bounded surfaces: those whose loops alone bound them, and trims whose two forms part. */
#include "exchange/reading.h"

#include <batten/body.h>
#include <batten/measure.h>

/* A line in space, from p in the direction d over its length. */
#define LINE(p, d) "0 0 120\n3\n" p "\n" d "\n1\n0 1\n0\n"
/* A square of side 2 in the plane z = 3, counter-clockwise. */
#define SQUARE                                                                          \
    "1\n4 1e-6\n" LINE("0 0 3", "2 0 0") LINE("2 0 3", "0 2 0") LINE("2 2 3", "-2 0 0") \
        LINE("0 2 3", "0 -2 0")
/* The same with the forms in the parameters of the plane alone. */
#define FLAT_LINE(p, d) "1 120 0\n2\n" p "\n" d "\n1\n0 1\n0\n"
#define FLAT_SQUARE                                                                        \
    "1\n4 1e-6\n" FLAT_LINE("0 0", "2 0") FLAT_LINE("2 0", "0 2") FLAT_LINE("2 2", "-2 0") \
        FLAT_LINE("0 2", "0 -2")
/* On the cylinder of radius 2 about z, a quarter from z = 0 to 1: arcs and lines. */
#define QUARTER                                                                                \
    "1\n4 1e-6\n0 0 130\n3\n2\n0 0 0\n0 0 1\n1 0 0\n0 1.5707963267948966\n0\n" LINE(           \
        "0 2 0",                                                                               \
        "0 0 1") "0 0 130\n3\n2\n0 0 1\n0 0 1\n1 0 0\n0 1.5707963267948966\n1\n" LINE("2 0 1", \
                                                                                      "0 0 -1")
#define RING(z, ends, turned) \
    "1 1e-6\n0 0 130\n3\n2\n0 0 " z "\n0 0 1\n1 0 0\n" ends "\n" turned "\n"

static const struct {
    const char *text;
    double area;
    const char *note;
} faces[] = {
    {"210 1 0 0\n250\n3\n0 0 3\n0 0 1\n1 0 0\n0\n0\n" SQUARE, 4, ""},
    {"210 1 0 0\n250\n3\n0 0 3\n0 0 -1\n1 0 0\n0\n1\n" SQUARE, 4, ""},
    {"210 1 0 0\n250\n3\n0 0 3\n0 0 1\n1 0 0\n0\n0\n" FLAT_SQUARE, 4, ""},
    {"210 1 0 0\n250\n3\n0 0 3\n0 0 1\n1 0 0\n0\n1\n" FLAT_SQUARE, 4, ""},
    {"210 1 0 0\n250\n3\n0 0 3\n0 0 1\n1 0 0\n1\n-1 3\n-1 3\n0\n" FLAT_SQUARE, 4, ""},
    {"210 1 0 0\n260\n3\n2\n0 0 0\n0 0 1\n1 0 0\n0\n0 6.283185307179586\n0\n" QUARTER,
     1.5707963267948966 * 2, ""},
    {"210 1 0 0\n260\n3\n2\n0 0 0\n0 0 1\n1 0 0\n0\n6.283185307179586 0\n0\n" QUARTER,
     1.5707963267948966 * 2, "a range runs backwards, from 6.28319 to 0"},
    {"210 1 0 0\n260\n3\n2\n0 0 0\n0 0 1\n1 0 0\n0\n0 6.283185307179586\n0\n2\n" RING(
         "0", "0 6.283185307179586", "0") RING("1", "0 6.283185307179586", "1"),
     6.283185307179586 * 2, ""},
    {"210 1 0 0\n260\n3\n2\n0 0 0\n0 0 1\n1 0 0\n0\n0 6.283185307179586\n0\n2\n" RING(
         "0", "0 6.283185307179586", "0") RING("1", "6.283185307179586 0", "0"),
     6.283185307179586 * 2, "a range runs backwards"},
    {"210 1 0 0\n280\n3\n2\n0 0 0\n0 0 1\n1 0 0\n-0.7853981633974483\n0\n0 "
     "6.283185307179586\n0\n1\n" RING("0", "0 6.283185307179586", "0"),
     3.141592653589793 * 2 * 2.8284271247461903, ""},
};

static double area_of(const batten_model *model)
{
    batten_body_trace_report report;
    batten_body *traced = NULL;
    batten_body_measures measures;
    CHECK_INT(batten_model_count(model), 1);
    CHECK_OK(batten_body_trace(batten_model_object(model, 0)->body, 1e-6, NULL, NULL, &report,
                               &traced));
    CHECK_INT(report.failed, 0);
    CHECK_OK(batten_body_measure(traced, 1e-9, NULL, &measures));
    batten_body_unref(traced);
    return measures.area;
}

TEST(a_bounded_surface_on_a_plane_cylinder_or_cone_without_bounds_is_bounded_by_its_loops)
{
    for (int k = 0; k < COUNT(faces); k++) {
        batten_model *model = read_noting(faces[k].text, BATTEN_FORMAT_AUTO, faces[k].note);
        CHECK_NEAR(area_of(model), faces[k].area, 1e-7);
        batten_model_unref(model);
    }
}

TEST(what_no_loop_bounds_is_left_out_by_name)
{
    check_refused("210 1 0 0\n250\n3\n0 0 3\n0 0 1\n1 0 0\n0\n0\n0\n", BATTEN_FORMAT_AUTO,
                  BATTEN_UNSUPPORTED, "reaches to infinity");
    check_refused(
        "210 1 0 0\n260\n3\n2\n0 0 0\n0 0 1\n1 0 0\n0\n0 6.283185307179586\n0\n1\n" RING(
            "0", "0 6.283185307179586", "0"),
        BATTEN_FORMAT_AUTO, BATTEN_UNSUPPORTED, "nothing bounds it on the other side");
    check_refused("250 1 0 0\n3\n0 0 3\n0 0 1\n1 0 0\n0\n0\n", BATTEN_FORMAT_AUTO,
                  BATTEN_UNSUPPORTED, "the surface has no bounds");
    check_refused("210 1 0 0\n260\n3\n2\n0 0 0\n0 0 1\n1 0 0\n0\n0 6\n0\n1\n1 1e-6\n"
                  "1 100 0\n2 0\n2 2\n0 0 1 1\n0 0\n6 0\n",
                  BATTEN_FORMAT_AUTO, BATTEN_UNSUPPORTED, "has no form in space");
}

/* A square in a square of side 4; the form in space is moved inward by 0.1. */
static const char *parted(int master)
{
    static const double x[] = {1, 3, 3, 1, 1}, y[] = {1, 1, 3, 3, 1};
    static char text[2000];
    int at = snprintf(text, sizeof text,
                      "210 1 0 0\n200\n3 0\n2 2\n0 0 4 4\n2 2\n0 0 4 4\n0 0 1\n4 0 1\n0 4 1\n"
                      "4 4 1\n1\n4 0.2\n");
    for (int k = 0; k < 4; k++) {
        at += snprintf(text + at, sizeof text - (size_t)at,
                       "%d 100 100\n2 0\n2 2\n0 0 1 1\n%g %g\n%g %g\n3 0\n2 2\n0 0 1 1\n",
                       master, x[k], y[k], x[k + 1], y[k + 1]);
        for (int e = 0; e < 2; e++)
            at += snprintf(text + at, sizeof text - (size_t)at, "%g %g 1\n",
                           2 + 0.9 * (x[k + e] - 2), 2 + 0.9 * (y[k + e] - 2));
    }
    return text;
}

static batten_model *through(const batten_model *model, batten_format format)
{
    batten_write_options options = batten_write_defaults();
    batten_model *back = NULL;
    char *data = NULL;
    size_t size = 0;
    options.format = format;
    CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
    CHECK_OK(read_bytes(data, size, format, NULL, &back));
    batten_release(data);
    return back;
}

TEST(where_the_forms_of_a_trim_part_its_master_counts_in_every_format)
{
    static const batten_format formats[] = {BATTEN_FORMAT_G2, BATTEN_FORMAT_STEP,
                                            BATTEN_FORMAT_IGES};
    for (int master = 0; master < 2; master++) {
        const double area = master ? 4 : 4 * 0.81;
        batten_notes *notes = NULL;
        batten_model *model = NULL;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(read_text(parted(master), BATTEN_FORMAT_AUTO, notes, &model));
        if (!batten_notes_dropped(notes))
            CHECK(has_note(notes, "what the file calls the master is taken"));
        CHECK_NEAR(area_of(model), area, 1e-9);
        for (int k = 0; k < COUNT(formats); k++) {
            batten_model *back = through(model, formats[k]);
            CHECK_NEAR(area_of(back), area, 1e-9);
            batten_model_unref(back);
        }
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

TEST(a_torus_of_negative_radius_is_read_as_its_formula_has_it)
{
    batten_model *model = read_noting("290 1 0 0\n3\n-5\n2\n0 0 0\n0 0 1\n1 0 0\n1\n",
                                      BATTEN_FORMAT_AUTO, "its radius is -5");
    const batten_box box = batten_surface_box(batten_model_object(model, 0)->surface);
    CHECK_NEAR(box.high.x, 7, 1e-12);
    CHECK_NEAR(box.high.z, 2, 1e-12);
    batten_model_unref(model);
}
