/* How a point of a surface looks: key and fill light, stripes, and colours of curvature. */
#include "picture/shaded/light.h"

static void normalise(double v[3])
{
    const double length = sqrt(bat_dot(3, v, v));
    for (int k = 0; k < 3; k++)
        v[k] /= length;
}

/* A direction given to the right, up, and towards the eye. */
static void from_view(const bat_view *view, double right, double up, double eye, double out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = right * view->right[k] + up * view->up[k] + eye * view->eye[k];
    normalise(out);
}

bat_scene bat_scene_make(batten_shading shading, const bat_view *view, int axis, double stripes)
{
    bat_scene scene = {.shading = shading, .stripes = stripes, .range = 1};
    from_view(view, 0, 0, 1, scene.eye);
    from_view(view, -0.45, 0.52, 0.72, scene.key);
    from_view(view, 0.72, -0.30, 0.62, scene.fill);
    for (int k = 0; k < 3; k++)
        scene.half[k] = scene.eye[k] + scene.key[k];
    normalise(scene.half);
    scene.along[axis] = 1;
    scene.across[(axis + 1) % 3] = 1;
    scene.third[(axis + 2) % 3] = 1;
    return scene;
}

/* The square is sRGB's curve closely enough; raster.c takes the root. */
bat_light bat_light_of(bat_colour colour)
{
    return (bat_light){colour.red * colour.red, colour.green * colour.green,
                       colour.blue * colour.blue};
}

static bat_light times(bat_light light, double factor)
{
    return (bat_light){factor * light.red, factor * light.green, factor * light.blue};
}

/* The normal on the side of the eye. */
static void face(const bat_scene *scene, const double n[3], double out[3])
{
    const double sign = bat_dot(3, n, scene->eye) < 0 ? -1 : 1;
    for (int k = 0; k < 3; k++)
        out[k] = sign * n[k];
}

/* How much light a white surface throws back, without gloss. */
static double diffuse(const bat_scene *scene, const double n[3])
{
    const double key = bat_max(0, bat_dot(3, n, scene->key));
    const double fill = bat_max(0, bat_dot(3, n, scene->fill));
    const double sky = 0.5 + 0.5 * n[2];
    return 0.15 + 0.16 * sky + 0.66 * key + 0.52 * fill;
}

/* The gloss of the key light, and a thin bright rim where the surface turns away. */
static double gloss(const bat_scene *scene, const double n[3])
{
    double shine = bat_max(0, bat_dot(3, n, scene->half));
    for (int i = 0; i < 5; i++)
        shine *= shine; /* to the power 32 */
    const double away = 1 - bat_max(0, bat_dot(3, n, scene->eye));
    return 0.14 * shine + 0.08 * away * away * away * away;
}

static bat_light plain_light(const bat_scene *scene, bat_light albedo, const double normal[3])
{
    double n[3];
    face(scene, normal, n);
    const double shine = gloss(scene, n);
    const bat_light light = times(albedo, diffuse(scene, n));
    return (bat_light){light.red + shine, light.green + shine, light.blue + shine};
}

static bat_light zebra_light(const bat_scene *scene, const double normal[3])
{
    double n[3], mirrored[3];
    face(scene, normal, n);
    const double facing = bat_dot(3, n, scene->eye);
    for (int k = 0; k < 3; k++)
        mirrored[k] = 2 * facing * n[k] - scene->eye[k];
    /* As the normal makes a half turn, its mirror image of the eye goes around once. */
    const double angle =
        bat_atan2(bat_dot(3, mirrored, scene->third), bat_dot(3, mirrored, scene->across));
    const double phase = angle * scene->stripes / (2 * BAT_PI);
    const bat_light dark = {0.006, 0.012, 0.028}, bright = {0.90, 0.92, 0.94};
    const bat_light stripe = phase - floor(phase) < 0.5 ? dark : bright;
    return times(stripe, 0.55 + 0.45 * diffuse(scene, n));
}

static bat_light isophote_light(const bat_scene *scene, const double normal[3])
{
    double n[3];
    face(scene, normal, n);
    const double angle = bat_acos(bat_max(-1, bat_min(1, bat_dot(3, n, scene->key))));
    const double phase = angle * scene->stripes / BAT_PI;
    const bat_light dark = {0.10, 0.16, 0.24}, bright = {0.90, 0.92, 0.94};
    return times(phase - floor(phase) < 0.5 ? bright : dark, 0.55 + 0.45 * diffuse(scene, n));
}

bat_colour bat_colour_diverging(double t)
{
    /* Even in lightness to both sides, so that neither sign looks larger. */
    static const bat_colour stops[] = {
        {0.10, 0.24, 0.55}, {0.27, 0.50, 0.78}, {0.64, 0.79, 0.90}, {0.96, 0.96, 0.95},
        {0.96, 0.74, 0.60}, {0.84, 0.38, 0.29}, {0.58, 0.07, 0.14}};
    const double place = 3 + 3 * bat_max(-1, bat_min(t, 1));
    const int i = bat_min_int((int)place, 5);
    const double part = place - i;
    const bat_colour a = stops[i], b = stops[i + 1];
    return (bat_colour){a.red + part * (b.red - a.red), a.green + part * (b.green - a.green),
                        a.blue + part * (b.blue - a.blue)};
}

static bat_light curvature_light(const bat_scene *scene, double curvature,
                                 const double normal[3])
{
    double n[3];
    face(scene, normal, n);
    const bat_colour colour = isnan(curvature) ? (bat_colour){0.5, 0.5, 0.5}
                                               : bat_colour_diverging(curvature / scene->range);
    return times(bat_light_of(colour), 0.55 + 0.5 * diffuse(scene, n));
}

bat_light bat_light_of_sample(const bat_scene *scene, bat_light albedo, double curvature,
                              const double n[3])
{
    switch (scene->shading) {
    case BATTEN_SHADING_ZEBRA:
        return zebra_light(scene, n);
    case BATTEN_SHADING_ISOPHOTES:
        return isophote_light(scene, n);
    case BATTEN_SHADING_GAUSSIAN:
    case BATTEN_SHADING_MEAN:
        return curvature_light(scene, curvature, n);
    default:
        return plain_light(scene, albedo, n);
    }
}
