/* Bounded surfaces of .g2 files: a surface and loops of curves on it, as one face. */
#include "body/trace/lift.h"
#include "exchange/g2/g2.h"

#include <string.h>

/* One curve of a loop: in the parameters, in space, or both. */
typedef struct {
    batten_curve *parameters, *space;
} trim;

static void release(bat_list *trims)
{
    trim *items = trims->items;
    for (size_t i = 0; i < trims->count; i++) {
        batten_curve_unref(items[i].parameters);
        batten_curve_unref(items[i].space);
    }
    bat_release(items);
    *trims = (bat_list){.size = sizeof(trim)};
}

/* "1 100 100": which is the master, and the classes of both curves, 0 for none; old files write
 * 1 for splines. */
static batten_status read_trim(bat_words *words, trim *t)
{
    int master = 0, classes[2] = {0, 0};
    batten_status status =
        bat_words_integer(words, "the mark of the master curve", 0, 1, &master);
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        status = bat_words_integer(words, "the class of a trimming curve", 0, 999, &classes[k]);
        if (classes[k] == 1)
            classes[k] = BAT_G2_CURVE;
    }
    if (status == BATTEN_OK && classes[0])
        status = bat_g2_read_curve(words, classes[0], false, &t->parameters);
    if (status == BATTEN_OK && classes[1])
        status = bat_g2_read_curve(words, classes[1], false, &t->space);
    if (status == BATTEN_OK && !t->parameters && !t->space)
        status = bat_input_fail(words->input, BATTEN_BAD_FORMAT, words->line,
                                "a trimming curve has neither form");
    if (status == BATTEN_OK && ((t->parameters && batten_curve_dimension(t->parameters) != 2) ||
                                (t->space && batten_curve_dimension(t->space) != 3)))
        status = bat_input_fail(words->input, BATTEN_BAD_FORMAT, words->line,
                                "a trimming curve has the wrong dimension");
    return status;
}

/* Is the curve one point, as where a loop passes a pole? */
static bool is_point(const batten_curve *curve, double tolerance)
{
    const double *p = batten_curve_points(curve);
    for (int i = 1; i < batten_curve_point_count(curve); i++)
        if (hypot(hypot(p[3 * i] - p[0], p[3 * i + 1] - p[1]), p[3 * i + 2] - p[2]) > tolerance)
            return false;
    return true;
}

/* The curve in space of a trim, made when the file has none. Parameters that are not those of
 * the surface go. */
static batten_status complete(bat_words *words, const batten_surface *surface, bool is_spline,
                              double tolerance, trim *t)
{
    double error = 0;
    if (!t->space && !is_spline)
        return bat_input_fail(words->input, BATTEN_UNSUPPORTED, words->line,
                              "a trimming curve on an elementary surface has no form in space");
    batten_status status = BATTEN_OK;
    if (!t->space) {
        status = bat_lift(surface, t->parameters, tolerance, &t->space, &error);
        if (status == BATTEN_OK && error > 0)
            batten_notes_add(
                words->input->notes, words->input->file, words->line, "bounded surface",
                "a curve in space was made from that in the parameters, within %g", error);
    }
    if (!is_spline) {
        batten_curve_unref(t->parameters);
        t->parameters = NULL;
    }
    return status;
}

static batten_status start_of(const batten_curve *curve, double point[3])
{
    return batten_curve_evaluate(curve, batten_curve_domain(curve).a, 0, point);
}

/* Edges and uses of a loop, head to tail: the start of each curve is a vertex. A pole ends
 * where it begins, and the next curve goes on from there; so a loop begins with those at its
 * end. */
static batten_status build_loop(bat_builder *builder, const bat_list *trims, double tolerance)
{
    const trim *items = trims->items;
    const int count = (int)trims->count;
    int turn = count;
    while (turn > 0 && is_point(items[turn - 1].space, tolerance))
        turn--;
    int first = 0, vertex = 0, edge = 0;
    bool after_pole = false;
    batten_status status = bat_builder_loop(builder);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const trim *t = &items[(i + turn) % count];
        const bool is_pole = is_point(t->space, tolerance);
        double point[3];
        status = start_of(t->space, point);
        if (status == BATTEN_OK && !after_pole)
            status = bat_builder_vertex(builder, point, &vertex);
        if (i == 0)
            first = vertex;
        const int end = is_pole ? vertex : i + 1 == count ? first : vertex + 1;
        if (status == BATTEN_OK)
            status = bat_builder_edge(builder, is_pole ? NULL : t->space, vertex, end, &edge);
        if (status == BATTEN_OK)
            status = bat_builder_use(builder, edge, false, t->parameters);
        after_pole = is_pole;
    }
    return status;
}

static batten_status read_loop(bat_words *words, const batten_surface *surface, bool is_spline,
                               bat_builder *builder)
{
    int count = 0;
    double tolerance = 0;
    bat_list trims = {.size = sizeof(trim)};
    batten_status status =
        bat_words_integer(words, "the number of curves of a loop", 1, 1000000, &count);
    if (status == BATTEN_OK)
        status = bat_words_real(words, "the tolerance of a loop", &tolerance);
    if (status == BATTEN_OK)
        status = bat_words_check(words, "curves of a loop", (size_t)count, 10);
    /* A twentieth: edges that are off their face are written with their true distance. */
    const double stated = tolerance;
    const batten_box box = batten_surface_box(surface);
    const double size =
        hypot(hypot(box.high.x - box.low.x, box.high.y - box.low.y), box.high.z - box.low.z);
    tolerance =
        stated > 0 ? bat_judged_accuracy(stated, size, 5e-2, stated) : builder->parts.tolerance;
    if (stated > 0 && tolerance != stated)
        batten_notes_remark(words->input->notes, words->input->file, words->line,
                            "bounded surface",
                            "a loop states a tolerance of %g at a size of %g; %g is used",
                            stated, size, tolerance);
    builder->parts.tolerance = bat_max(builder->parts.tolerance, tolerance);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        trim t = {NULL, NULL};
        status = read_trim(words, &t);
        if (status == BATTEN_OK)
            status = complete(words, surface, is_spline, tolerance, &t);
        if (status == BATTEN_OK)
            status = bat_list_add(words->input, &trims, &t);
        if (status != BATTEN_OK) {
            batten_curve_unref(t.parameters);
            batten_curve_unref(t.space);
        }
    }
    if (status == BATTEN_OK)
        status = build_loop(builder, &trims, tolerance);
    release(&trims);
    return status;
}

batten_status bat_g2_read_face(bat_words *words, const batten_body_face *look,
                               batten_body **out)
{
    int class = 0, loops = 0;
    bool is_spline = false;
    batten_surface *surface = NULL;
    bat_builder builder;
    /* Only to begin with: the tolerance of the body is that of its loops. */
    bat_builder_begin(&builder, 1e-12);
    batten_body_face face = *look;
    batten_status status =
        bat_words_integer(words, "the class of the bounded surface", 0, 999, &class);
    if (status == BATTEN_OK)
        status = bat_g2_read_surface(words, class, false, &is_spline, &surface);
    if (status == BATTEN_OK)
        status = bat_words_integer(words, "the number of loops", 0, 1000000, &loops);
    face.surface = surface;
    if (status == BATTEN_OK)
        status = bat_builder_shell(&builder, false);
    if (status == BATTEN_OK)
        status = bat_builder_face(&builder, &face);
    for (int i = 0; status == BATTEN_OK && i < loops; i++)
        status = read_loop(words, surface, is_spline, &builder);
    if (status == BATTEN_OK)
        status = bat_builder_finish(&builder, false, out);
    else
        bat_builder_end(&builder);
    batten_surface_unref(surface);
    return status;
}
