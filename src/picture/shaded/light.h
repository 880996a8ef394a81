/* What colour a sample of a surface has: light, stripes, colours of curvature. All in linear
 * light. */
#ifndef BAT_LIGHT_H
#define BAT_LIGHT_H
#include "picture/sheet/canvas.h"
#include "picture/sheet/view.h"

typedef struct {
    double red, green, blue;
} bat_light;

/* What all samples of a picture share. */
typedef struct {
    batten_shading shading;
    double eye[3], key[3], fill[3],
        half[3]; /* unit vectors in space; half lies between eye and key */
    double along[3], across[3], third[3]; /* the zebra's tubes run along the first */
    double stripes;
    double range; /* the curvature at the ends of the colours */
} bat_scene;

/* Lights that stand with the eye: the key to the left and above, the fill to the right. The
 * tubes of the zebra run along `axis` (0, 1, 2). */
bat_scene bat_scene_make(batten_shading shading, const bat_view *view, int axis,
                         double stripes);

/* The light of colour sRGB. */
bat_light bat_light_of(bat_colour colour);

/* The colour of a curvature without light, sRGB, for t in -1 .. 1: of the Gaussian red for bowls
 * and domes, blue for saddles. */
bat_colour bat_colour_diverging(double t);

/* What the shading of the scene makes of a sample with the unit normal n, which may point to
 * either side. Plain: of the material `albedo`. Zebra: the mirror image of a half turn of
 * parallel tubes; a cylinder along the tubes shows `stripes` dark ones from edge to edge.
 * Isophotes: stripes of equal angle between the normal and the key light. Else the colour of
 * the curvature, grey for NaN. */
bat_light bat_light_of_sample(const bat_scene *scene, bat_light albedo, double curvature,
                              const double n[3]);

#endif
