/* Bounded surfaces of .g2 files: a surface and loops of curves on it, as one face. */
#include "exchange/g2/g2.h"
#include "numeric/box.h"
#include "numeric/vector.h"

#include <string.h>

typedef struct {
    int count;     /* of its trims */
    double stated; /* its tolerance in the file */
    int line;
} loop;

typedef struct {
    bat_words *words;
    bat_g2_ground ground;
    bat_list trims; /* of all loops, one after another */
    bat_list loops;
    double size, tolerance; /* of what the loops are, and of the body so far */
} face_reading;

static void release_trims(bat_list *trims)
{
    bat_g2_trim *items = trims->items;
    for (size_t i = 0; i < trims->count; i++) {
        batten_curve_unref(items[i].parameters);
        batten_curve_unref(items[i].space);
    }
    bat_release(items);
}

/* Is the curve one point, as where a loop passes a pole? */
static bool is_point(const batten_curve *curve, double tolerance)
{
    const double *p = batten_curve_points(curve);
    for (int i = 1; i < batten_curve_point_count(curve); i++)
        if (bat_hypot(bat_hypot(p[3 * i] - p[0], p[3 * i + 1] - p[1]), p[3 * i + 2] - p[2]) >
            tolerance)
            return false;
    return true;
}

static batten_status start_of(const batten_curve *curve, double point[3])
{
    return batten_curve_evaluate(curve, batten_curve_domain(curve).a, 0, point);
}

/* Edges and uses of a loop, head to tail: the start of each curve is a vertex. A pole ends
 * where it begins, and the next curve goes on from there; so a loop begins with those at its
 * end. */
static batten_status build_loop(bat_builder *builder, const bat_g2_trim *items, int count,
                                double tolerance)
{
    int turn = count;
    while (turn > 0 && is_point(items[turn - 1].space, tolerance))
        turn--;
    int first = 0, vertex = 0, edge = 0;
    bool after_pole = false;
    batten_status status = bat_builder_loop(builder);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const bat_g2_trim *t = &items[(i + turn) % count];
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

/* ---- a face, read before it is built: where it has no bounds, its loops are them ---- */

static batten_status read_loop(face_reading *r)
{
    bat_words *words = r->words;
    loop made = {.line = words->line};
    batten_status status =
        bat_words_integer(words, "the number of curves of a loop", 1, 1000000, &made.count);
    if (status == BATTEN_OK)
        status = bat_words_real(words, "the tolerance of a loop", &made.stated);
    if (status == BATTEN_OK)
        status = bat_words_check(words, "curves of a loop", (size_t)made.count, 10);
    if (status == BATTEN_OK)
        status = bat_list_add(words->input, &r->loops, &made);
    for (int i = 0; status == BATTEN_OK && i < made.count; i++) {
        bat_g2_trim t;
        status = bat_g2_read_trim(words, &r->ground, &t);
        if (status == BATTEN_OK)
            status = bat_list_add(words->input, &r->trims, &t);
        if (status != BATTEN_OK) {
            batten_curve_unref(t.parameters);
            batten_curve_unref(t.space);
        }
    }
    return status;
}

/* A twentieth: edges that are off their face are written with their true distance. */
static double judge_tolerance(const face_reading *r, const loop *of)
{
    const bat_input *input = r->words->input;
    const double judged = of->stated > 0
                              ? bat_judged_accuracy(of->stated, r->size, 5e-2, of->stated)
                              : r->tolerance;
    if (of->stated > 0 && judged != of->stated)
        batten_notes_remark(input->notes, input->file, of->line, "bounded surface",
                            "a loop states a tolerance of %g at a size of %g; %g is used",
                            of->stated, r->size, judged);
    return judged;
}

static batten_status add_samples(bat_input *input, const batten_curve *curve, bat_list *points)
{
    enum { EACH = 8, MOST = 1000 };
    const batten_interval domain = batten_curve_domain(curve);
    const int steps = bat_min_int(MOST, EACH * batten_curve_spans(curve, NULL));
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i <= steps; i++) {
        const double t = i < steps ? domain.a + i * (domain.b - domain.a) / steps : domain.b;
        double point[3];
        status = batten_curve_evaluate(curve, t, 0, point);
        if (status == BATTEN_OK)
            status = bat_list_add(input, points, point);
    }
    return status;
}

/* Points of all trims, of an unbounded surface; they must be in space. */
static batten_status sample_trims(face_reading *r, bat_around *around, bat_list *points)
{
    const bat_g2_trim *trims = r->trims.items;
    batten_box box = bat_box_of_nothing();
    batten_status status = BATTEN_OK;
    for (size_t i = 0; status == BATTEN_OK && i < r->trims.count; i++) {
        if (!trims[i].space)
            return bat_input_fail(
                r->words->input, BATTEN_UNSUPPORTED, r->words->line,
                "a trimming curve on an elementary surface has no form in space");
        status = add_samples(r->words->input, trims[i].space, points);
        if (status == BATTEN_OK)
            status = bat_around_add(around, trims[i].space, false);
    }
    for (size_t k = 0; k < points->count; k++)
        bat_box_join(&box, bat_box_at((const double *)points->items + 3 * k));
    r->size = points->count ? bat_box_diagonal(box) : 0;
    return status;
}

/* As much of the surface as its loops need. */
static batten_status bound_by_loops(face_reading *r)
{
    bat_list points = {.size = 3 * sizeof(double)};
    batten_surface *made = NULL;
    bat_around around;
    double error = 0;
    batten_status status = bat_around_begin(&r->ground.unbounded, 0, &around);
    if (status == BATTEN_OK)
        status = sample_trims(r, &around, &points);
    r->ground.unbounded.goes_on = status == BATTEN_OK && bat_around_is_once(&around);
    if (status == BATTEN_OK)
        status = bat_elementary_surface(&r->ground.unbounded, (int)points.count, points.items,
                                        BAT_WRITTEN * r->size, &made, &error);
    if (status == BATTEN_OK && r->ground.is_swapped)
        status = batten_surface_swap(made, &r->ground.surface);
    else if (status == BATTEN_OK)
        r->ground.surface = batten_surface_ref(made);
    batten_surface_unref(made);
    bat_release(points.items);
    return status;
}

static batten_status read_parts(face_reading *r)
{
    int class = 0, loops = 0;
    batten_status status =
        bat_words_integer(r->words, "the class of the bounded surface", 0, 999, &class);
    if (status == BATTEN_OK)
        status = bat_g2_read_surface(r->words, class, false, &r->ground);
    if (status == BATTEN_OK)
        status = bat_words_integer(r->words, "the number of loops", 0, 1000000, &loops);
    for (int i = 0; status == BATTEN_OK && i < loops; i++)
        status = read_loop(r);
    if (status == BATTEN_OK && !r->ground.surface)
        status = bound_by_loops(r);
    else if (status == BATTEN_OK)
        r->size = bat_box_diagonal(batten_surface_box(r->ground.surface));
    return status;
}

static batten_status build_face(face_reading *r, const batten_body_face *look,
                                bat_builder *builder)
{
    batten_body_face face = *look;
    const loop *loops = r->loops.items;
    bat_g2_trim *trims = r->trims.items;
    double parted = 0;
    face.surface = r->ground.surface;
    batten_status status = bat_builder_shell(builder, false);
    if (status == BATTEN_OK)
        status = bat_builder_face(builder, &face);
    for (size_t k = 0; status == BATTEN_OK && k < r->loops.count; k++) {
        const double tolerance = judge_tolerance(r, &loops[k]);
        builder->parts.tolerance = r->tolerance = bat_max(r->tolerance, tolerance);
        for (int i = 0; status == BATTEN_OK && i < loops[k].count; i++)
            status = bat_g2_settle_trim(r->words, &r->ground, r->size, tolerance, &trims[i],
                                        &parted);
        if (status == BATTEN_OK)
            status = build_loop(builder, trims, loops[k].count, tolerance);
        trims += loops[k].count;
    }
    if (parted > 0)
        batten_notes_remark(r->words->input->notes, r->words->input->file, r->words->line,
                            "bounded surface",
                            "its trimming curves in space are up to %g from those in the "
                            "parameters; what the file calls the master is taken",
                            parted);
    return status;
}

batten_status bat_g2_read_face(bat_words *words, const batten_body_face *look,
                               batten_body **out)
{
    /* Only to begin with: the tolerance of the body is that of its loops. */
    const double least = 1e-12;
    face_reading r = {.words = words,
                      .trims = {.size = sizeof(bat_g2_trim)},
                      .loops = {.size = sizeof(loop)},
                      .tolerance = least};
    bat_builder builder;
    bat_builder_begin(&builder, least);
    batten_status status = read_parts(&r);
    if (status == BATTEN_OK)
        status = build_face(&r, look, &builder);
    if (status == BATTEN_OK)
        status = bat_builder_finish(&builder, false, out);
    else
        bat_builder_end(&builder);
    batten_surface_unref(r.ground.surface);
    release_trims(&r.trims);
    bat_release(r.loops.items);
    return status;
}
