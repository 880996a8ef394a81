/* How many triangles a body will need, before any work. */
#include "mesh/faces/lattice.h"

/* The border of a face in (u, v), a few samples for each use: its box, and the area around it.
 */
typedef struct {
    batten_interval box[2];
    double area;
    bool any;
} outline;

enum { EACH = 8 };

static batten_status add_use(const batten_body_use *use, const double origin[2], outline *o)
{
    const batten_interval domain = batten_curve_domain(use->parameters);
    double last[2] = {0, 0};
    for (int i = 0; i <= EACH; i++) {
        const double part = (double)(use->reversed ? EACH - i : i) / EACH;
        double uv[2];
        const batten_status status = batten_curve_evaluate(
            use->parameters, part == 1 ? domain.b : domain.a + part * (domain.b - domain.a), 0,
            uv);
        if (status != BATTEN_OK)
            return status;
        for (int k = 0; k < 2; k++) {
            o->box[k].a = o->any ? bat_min(o->box[k].a, uv[k]) : uv[k];
            o->box[k].b = o->any ? bat_max(o->box[k].b, uv[k]) : uv[k];
        }
        o->any = true;
        const double x = uv[0] - origin[0], y = uv[1] - origin[1];
        o->area += i ? (last[0] * y - last[1] * x) / 2 : 0;
        last[0] = x;
        last[1] = y;
    }
    return BATTEN_OK;
}

static batten_status predict_face(const bat_meshing *m, int face, double *count)
{
    const batten_body_face *f = &m->parts->faces[face];
    const bat_sheet *sheet = &m->sheets[face];
    const double origin[2] = {sheet->domain[0].a, sheet->domain[1].a};
    outline o = {.area = 0};
    bat_lattice lattice;
    batten_status status = BATTEN_OK;
    for (int i = f->first; status == BATTEN_OK && i < f->first + f->count; i++)
        for (int k = 0; status == BATTEN_OK && k < m->parts->loops[i].count; k++)
            status = add_use(&m->parts->uses[m->parts->loops[i].first + k], origin, &o);
    const double whole = (o.box[0].b - o.box[0].a) * (o.box[1].b - o.box[1].a);
    *count = 0;
    if (status != BATTEN_OK || !(whole > 0))
        return status;
    status = bat_lattice_begin(&lattice, m, sheet, o.box);
    if (status == BATTEN_OK) {
        *count = lattice.predicted * bat_min(fabs(o.area) / whole, 1);
        bat_lattice_end(&lattice);
    }
    return status;
}

/* Triangles of all faces; what is wrong with one comes to light later. */
static batten_status predict_all(const bat_meshing *m, double *all)
{
    /* Cells are halved until they are small enough, so there are about twice as many as would
     * do: of files of many programs 1.6 to 3.2 times. A plane has no cells. */
    static const double halved = 2;
    *all = 0;
    for (int i = 0; i < m->parts->face_count; i++) {
        double count = 0;
        const batten_status status = predict_face(m, i, &count);
        if (status == BATTEN_OUT_OF_MEMORY)
            return status;
        *all += count > 4 ? halved * count : count;
    }
    return BATTEN_OK;
}

/* A chord with which half of what is allowed would do; 0 when the angle, or the length of
 * edges, ask for more than that anyhow. */
static batten_status find_chord(const bat_meshing *m, double *chord)
{
    enum { TRIES = 16 };
    bat_meshing tried = *m;
    batten_status status = BATTEN_OK;
    *chord = 0;
    for (int i = 0; status == BATTEN_OK && *chord == 0 && i < TRIES; i++) {
        double all = 0;
        tried.chord *= 4;
        tried.fine *= 4;
        status = predict_all(&tried, &all);
        if (all <= 0.5 * m->most)
            *chord = tried.chord;
    }
    return status;
}

batten_status bat_meshing_predict(bat_meshing *m)
{
    double all = 0, chord = 0;
    batten_status status = predict_all(m, &all);
    if (status != BATTEN_OK || !(all > 1.25 * m->most))
        return status;
    status = find_chord(m, &chord);
    if (status != BATTEN_OK)
        return status;
    if (chord > 0)
        return bat_fail(
            BATTEN_TOO_LARGE,
            "about %.2g triangles are needed for a chord of %g and an angle of %g; %d "
            "are allowed, for which a chord of %.2g would do",
            all, m->chord, m->angle, m->most, chord);
    return bat_fail(BATTEN_TOO_LARGE,
                    "about %.2g triangles are needed for a chord of %g and an angle of %g; %d "
                    "are allowed, for which no chord would do",
                    all, m->chord, m->angle, m->most);
}
