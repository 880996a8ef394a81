/*
 * A body as it grows, part after part: for readers and for what cuts bodies.
 *
 * Order: vertices and edges at any time; uses belong to the loop begun last, loops to the face
 * begun last, faces to the shell begun last. A face that turns out bad is taken back with
 * bat_builder_mark and bat_builder_back: its loops and uses go; its edges and vertices stay,
 * and bat_builder_finish drops what no loop uses.
 */
#ifndef BAT_BODY_BUILDER_H
#define BAT_BODY_BUILDER_H
#include "base/base.h"
#include <batten/body.h>

typedef struct {
    batten_body_parts parts; /* counts, and arrays that grow; names are owned, geometry is
                                referenced */
    int vertex_room, edge_room, use_room, loop_room, face_room, shell_room;
} bat_builder;

void bat_builder_begin(bat_builder *builder, double tolerance);
/* The index of the new vertex, edge. The curve is referenced; NULL for a pole. */
batten_status bat_builder_vertex(bat_builder *builder, const double point[3], int *index);
batten_status bat_builder_edge(bat_builder *builder, const batten_curve *curve, int start,
                               int end, int *index);
batten_status bat_builder_shell(bat_builder *builder, bool closed);
/* Only name, colour, surface and `reversed` are taken; the name is copied. */
batten_status bat_builder_face(bat_builder *builder, const batten_body_face *face);
batten_status bat_builder_loop(bat_builder *builder);
batten_status bat_builder_use(bat_builder *builder, int edge, bool reversed,
                              const batten_curve *parameters);
/* The number of faces so far, and taking back all faces from there on. */
int bat_builder_mark(const bat_builder *builder);
void bat_builder_back(bat_builder *builder, int mark);
/* Say of no shell any more that it is closed: some of its faces are missing. */
void bat_builder_open_shells(bat_builder *builder);
/* Let the loops of a face run the other way around. */
void bat_builder_turn(bat_builder *builder, int face);
/* Make the body; shells without faces, and edges and vertices without use, are dropped. The
 * builder is empty afterwards, also on failure. */
batten_status bat_builder_finish(bat_builder *builder, bool is_solid, batten_body **out);
/* Give up. */
void bat_builder_end(bat_builder *builder);

#endif
