#include "body/check/sheet.h"
#include "body/builder.h"
#include "support/test.h"

#include <batten/standard.h>

batten_body *sheet_with_loops(int count, const double (*corners)[2], const int *sizes,
                              int loops)
{
    static const double square[4][2] = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    static const double knots[4] = {0, 0, 6, 6};
    static const double net[12] = {0, 0, 0, 0, 6, 0, 6, 0, 0, 6, 6, 0};
    const batten_axis axis = {1, 2, knots, false};
    batten_surface *surface = NULL;
    bat_builder b;
    bat_builder_begin(&b, 1e-6);
    CHECK_OK(bat_builder_shell(&b, false));
    CHECK_OK(batten_surface_create(3, &axis, &axis, net, NULL, &surface));
    const batten_body_face face = {.name = "sheet", .surface = surface};
    CHECK_OK(bat_builder_face(&b, &face));
    batten_surface_unref(surface);
    int first = 0, v[16], e = 0;
    for (int l = -1; l < loops; l++) {
        const double(*at)[2] = l < 0 ? square : corners + first;
        const int n = l < 0 ? 4 : sizes[l];
        CHECK_OK(bat_builder_loop(&b));
        for (int i = 0; i < n; i++) /* vertices in the same place are one */
            for (v[i] = -1; v[i] < 0;) {
                for (int k = 0; k < b.parts.vertex_count; k++)
                    if (b.parts.vertices[3 * k] == at[i][0] &&
                        b.parts.vertices[3 * k + 1] == at[i][1])
                        v[i] = k;
                if (v[i] < 0)
                    CHECK_OK(bat_builder_vertex(&b, (double[]){at[i][0], at[i][1], 0}, &v[i]));
            }
        for (int i = 0; i < n; i++) {
            const int k = (i + 1) % n;
            batten_curve *line = NULL, *flat = NULL;
            CHECK_OK(batten_curve_line(2, at[i], at[k], &flat));
            CHECK_OK(batten_curve_to_dimension(flat, 3, &line));
            CHECK_OK(bat_builder_edge(&b, line, v[i], v[k], &e));
            CHECK_OK(bat_builder_use(&b, e, false, flat));
            batten_curve_unref(line);
            batten_curve_unref(flat);
        }
        first += l < 0 ? 0 : n;
    }
    CHECK_INT(first, count);
    batten_body *body = NULL;
    b.parts.is_traced = true;
    CHECK_OK(batten_body_create(&b.parts, &body));
    bat_builder_end(&b);
    return body;
}
