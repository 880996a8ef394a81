#include "body/trace/traced.h"
#include "support/test.h"

static void check_use(const batten_body_parts *p, const batten_surface *surface,
                      const batten_body_use *use, double tolerance, double *area)
{
    const batten_body_edge *edge = &p->edges[use->edge];
    const batten_interval on = batten_curve_domain(use->parameters);
    double before[2] = {0, 0}, sum = 0;
    for (int i = 0; i <= 50; i++) {
        const double t = i < 50 ? on.a + (on.b - on.a) * i / 50 : on.b;
        double uv[2], s[3], c[3];
        CHECK_OK(batten_curve_evaluate(use->parameters, t, 0, uv));
        for (int k = 0; k < 2; k++) {
            const batten_interval domain =
                batten_surface_domain(surface, k ? BATTEN_V : BATTEN_U);
            const double little = 4 * DBL_EPSILON * fmax(fabs(domain.a), fabs(domain.b));
            CHECK(uv[k] >= domain.a - little && uv[k] <= domain.b + little);
        }
        CHECK_OK(batten_surface_evaluate(surface, uv[0], uv[1], 0, s));
        if (edge->curve)
            CHECK_OK(batten_curve_evaluate(edge->curve, t, 0, c));
        else
            memcpy(c, p->vertices + 3 * edge->vertices[0], sizeof c);
        CHECK_NEAR(hypot(hypot(s[0] - c[0], s[1] - c[1]), s[2] - c[2]), 0, tolerance);
        if (i)
            sum += before[0] * uv[1] - before[1] * uv[0];
        memcpy(before, uv, sizeof before);
    }
    if (edge->curve) {
        CHECK_BITS(on.a, batten_curve_domain(edge->curve).a);
        CHECK_BITS(on.b, batten_curve_domain(edge->curve).b);
    }
    *area += use->reversed ? -sum / 2 : sum / 2;
}

void check_traced(const batten_body *body, double tolerance)
{
    const batten_body_parts *p = batten_body_view(body);
    CHECK(p->is_traced);
    for (int f = 0; f < p->face_count; f++) {
        CHECK(p->faces[f].count > 0);
        for (int l = 0; l < p->faces[f].count; l++) {
            const batten_body_loop *loop = &p->loops[p->faces[f].first + l];
            double area = 0;
            for (int k = 0; k < loop->count; k++) {
                const batten_body_use *use = &p->uses[loop->first + k];
                const batten_body_use *next = &p->uses[loop->first + (k + 1) % loop->count];
                const batten_interval on = batten_curve_domain(use->parameters);
                const batten_interval then = batten_curve_domain(next->parameters);
                double end[2], begin[2];
                check_use(p, p->faces[f].surface, use, tolerance, &area);
                CHECK_OK(batten_curve_evaluate(use->parameters, use->reversed ? on.a : on.b, 0,
                                               end));
                CHECK_OK(batten_curve_evaluate(next->parameters,
                                               next->reversed ? then.b : then.a, 0, begin));
                CHECK_BITS(end[0] + 0.0, begin[0] + 0.0);
                CHECK_BITS(end[1] + 0.0, begin[1] + 0.0);
            }
            CHECK((area > 0) == ((l == 0) != p->faces[f].reversed));
        }
    }
}
