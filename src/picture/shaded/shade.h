/* A shaded picture while it is made: its surfaces, meshes, curves and light. */
#ifndef BAT_SHADE_H
#define BAT_SHADE_H
#include "numeric/box.h"
#include "picture/lines/stroke.h"
#include "picture/lines/tiles.h"
#include "picture/shaded/light.h"
#include "picture/shaded/mesh_solid.h"
#include "picture/shaded/raster.h"
#include "picture/shaded/smooth_edges.h"
#include "picture/sheet/flat.h"
#include "picture/sheet/sheet.h"
#include "picture/sheet/size.h"

/* What each sample of a surface carries. */
enum { BAT_SAMPLE_NORMAL = 0, BAT_SAMPLE_CURVATURE = 3 };

/* One surface, ready to be filled in. */
typedef struct {
    bat_tiles tiles; /* after fit_picture its points are in samples, depth towards the eye */
    const bat_scene *scene;
    bat_light albedo;
    bat_strokes edges;    /* where the domain ends, but for sides that continue in others */
    bat_strokes isolines; /* inside; in samples too after fit_picture */
} bat_shaded_solid;

/* How a stroke is drawn. */
typedef struct {
    bat_light light;
    double dot; /* radius of the marks of its points, samples; 0: it is a line */
} bat_shaded_style;

typedef struct {
    const batten_model *model;
    unsigned char *smooth;        /* [count of the model], see smooth_edges.h */
    batten_draw_options *options; /* their height is known after fit_picture */
    const batten_job *job;
    bat_view view;
    bat_scene scene;
    int solid_count, mesh_count;
    bat_shaded_solid *solids;
    bat_mesh_solid *meshes;
    bat_strokes curves; /* and rows of points; after fit_picture in samples too */
    bat_shaded_style *styles;
    double least, greatest; /* raw curvatures */
    double em;
} bat_shaded;

static inline bat_curvature bat_curvature_of_shading(batten_shading shading)
{
    return shading == BATTEN_SHADING_GAUSSIAN ? BAT_CURVATURE_GAUSSIAN
           : shading == BATTEN_SHADING_MEAN   ? BAT_CURVATURE_MEAN
                                              : BAT_CURVATURE_NONE;
}

static inline bool bat_has_stripes(batten_shading shading)
{
    return shading == BATTEN_SHADING_ZEBRA || shading == BATTEN_SHADING_ISOPHOTES;
}

/* ---- shade_gather.c ---- */

/* Count the surfaces and meshes, and find their box. */
void bat_shaded_count(bat_shaded *p, batten_box *box);
/* Tile the surfaces, copy meshes, curves and points. @param size  the diagonal of the box */
batten_status bat_shaded_gather(bat_shaded *p, double size);

/* ---- shade_range.c ---- */

/* Set `scene.range`, beyond which colours do not change, and the extremes of the curvature. @param size  as above */
batten_status bat_shaded_choose_range(bat_shaded *p, double size);

/* ---- shade_around.c ---- */

/* What title and legend take of the height. */
double bat_shaded_around(const bat_shaded *p);
/* The part of the picture that title and legend leave to the shape; its height is that of the options. */
bat_rectangle bat_shaded_stage(const bat_shaded *p);
/* The title, and the legend of colours or stripes. */
void bat_shaded_write_around(bat_canvas *canvas, const bat_shaded *p);

/* ---- shade_fill.c ---- */

/* Fill the image of a canvas, band by band. */
batten_status bat_shaded_fill(const bat_shaded *p, bat_canvas *canvas);

#endif
