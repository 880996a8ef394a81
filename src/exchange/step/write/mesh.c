/* Triangles as AP242 has them. */
#include "exchange/step/write/writing.h"

#include <string.h>

static int put_coordinates(bat_step *step, const batten_mesh_parts *p)
{
    const int id = bat_step_open(step, "COORDINATES_LIST");
    bat_step_token(step, "'',");
    bat_step_integer(step, p->vertex_count, ",(");
    for (int i = 0; i < p->vertex_count; i++)
        for (int k = 0; k < 3; k++) {
            if (k == 0)
                bat_step_token(step, "(");
            bat_step_real(step, p->points[3 * (size_t)i + (size_t)k],
                          k < 2                     ? ","
                          : i + 1 < p->vertex_count ? "),"
                                                    : "))");
        }
    bat_step_close(step);
    return id;
}

int bat_step_put_mesh(bat_step *step, const char *name, const batten_mesh *mesh)
{
    const batten_mesh_parts *p = batten_mesh_view(mesh);
    const int coordinates = put_coordinates(step, p);
    const int face = bat_step_open(step, "TRIANGULATED_FACE");
    bat_step_string(step, name, ",");
    bat_step_id(step, coordinates, ",");
    bat_step_integer(step, p->vertex_count, ",(),$,(),(");
    for (int i = 0; i < p->triangle_count; i++)
        for (int k = 0; k < 3; k++) {
            if (k == 0)
                bat_step_token(step, "(");
            bat_step_integer(step, p->corners[3 * (size_t)i + (size_t)k] + 1,
                             k < 2                       ? ","
                             : i + 1 < p->triangle_count ? "),"
                                                         : "))");
        }
    bat_step_close(step);
    const int id = bat_step_open(step, "TESSELLATED_SHELL");
    bat_step_string(step, name, ",(");
    bat_step_id(step, face, "),$");
    bat_step_close(step);
    return id;
}
