/* Faces of IGES put together by hand: loops of lines, bodies read, their areas. */
#ifndef TESTS_EXCHANGE_IGES_FACES_H
#define TESTS_EXCHANGE_IGES_FACES_H
#include "base/base.h"
#include "exchange/iges/text.h"

#define IGES_SQUARE                                                                            \
    "128,1,1,1,1,0,0,1,0,0,0.,0.,4.,4.,0.,0.,4.,4.,1.,1.,1.,1.,0.,0.,0.,4.,0.,0.,0.,4.,0.,4.," \
    "4.,0.,0.,4.,0.,4.;"

/* Four lines around a square from (a, a) to (b, b), counter-clockwise, and their 102. */
static inline int iges_add_square(iges_text *file, double a, double b, const char *status,
                                  bool clockwise)
{
    const double x[] = {a, b, b, a}, y[] = {a, a, b, b};
    char text[120];
    int ids[4];
    for (int i = 0; i < 4; i++) {
        const int from = clockwise ? (4 - i) % 4 : i, to = clockwise ? 3 - i : (i + 1) % 4;
        snprintf(text, sizeof text, "110,%g,%g,0.,%g,%g,0.;", x[from], y[from], x[to], y[to]);
        ids[i] = iges_add(file, 110, 0, 0, 0, status, text);
    }
    snprintf(text, sizeof text, "102,4,%d,%d,%d,%d;", ids[0], ids[1], ids[2], ids[3]);
    return iges_add(file, 102, 0, 0, 0, status, text);
}

/* A 142 with a square in space, in (u, v), or both. */
static inline int iges_add_boundary(iges_text *file, int surface, double a, double b,
                                    bool in_plane, bool in_space, bool clockwise)
{
    char text[80];
    const int u = in_plane ? iges_add_square(file, a, b, "00010500", clockwise) : 0;
    const int s = in_space ? iges_add_square(file, a, b, "00010000", clockwise) : 0;
    snprintf(text, sizeof text, "142,1,%d,%d,%d,2;", surface, u, s);
    return iges_add(file, 142, 0, 0, 0, "00010000", text);
}

static inline batten_model *iges_body(iges_text *file, const char *note)
{
    batten_model *model = read_noting(iges_end(file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, note);
    CHECK_INT(batten_model_count(model), 1);
    CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_BODY);
    return model;
}

static inline void iges_check_area(const batten_model *model, double area)
{
    batten_body_trace_report report;
    batten_body *traced = NULL;
    batten_body_measures measures;
    CHECK_OK(batten_body_trace(batten_model_object(model, 0)->body, 1e-6, NULL, NULL, &report,
                               &traced));
    CHECK_INT(report.failed, 0);
    CHECK_OK(batten_body_measure(traced, 1e-9, NULL, &measures));
    CHECK_NEAR(measures.area, area, 1e-8 * bat_max(1, area));
    batten_body_unref(traced);
}

/* The curve of each use in (u, v) must run as its edge does, and lie below it. @return how many have one */
static inline int iges_check_plane_curves(const batten_model *model)
{
    const batten_body_parts *p = batten_body_view(batten_model_object(model, 0)->body);
    int count = 0;
    for (int f = 0; f < p->face_count; f++)
        for (int l = p->faces[f].first; l < p->faces[f].first + p->faces[f].count; l++)
            for (int i = p->loops[l].first; i < p->loops[l].first + p->loops[l].count; i++) {
                const batten_curve *curves[2] = {p->uses[i].parameters,
                                                 p->edges[p->uses[i].edge].curve};
                count += curves[0] != NULL;
                for (int k = 0; curves[0] && k <= 4; k++) {
                    double at[2][3], s[3];
                    for (int j = 0; j < 2; j++) {
                        const batten_interval d = batten_curve_domain(curves[j]);
                        CHECK_OK(batten_curve_evaluate(curves[j], d.a + k * (d.b - d.a) / 4, 0,
                                                       at[j]));
                    }
                    CHECK_OK(
                        batten_surface_evaluate(p->faces[f].surface, at[0][0], at[0][1], 0, s));
                    for (int j = 0; j < 3; j++)
                        CHECK_NEAR(s[j], at[1][j], 1e-9);
                }
            }
    return count;
}

#endif
