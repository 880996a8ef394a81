/* The sources of the methods, spelt out, and the places in them on which features stand. */
#include "design/feature.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static const batten_source sources[] = {
#define SOURCE(key, citation) {key, citation},
#include "design/sources.list"
#undef SOURCE
};

static const batten_source_place places[] = {
#define PLACE(key, place, subject, without) {key, place, subject, without},
#include "design/places.list"
#undef PLACE
};

const batten_source *batten_source_find(const char *key)
{
    for (size_t i = 0; i < sizeof sources / sizeof sources[0]; i++)
        if (strcmp(sources[i].key, key) == 0)
            return &sources[i];
    return NULL;
}

int batten_source_place_count(void)
{
    return (int)(sizeof places / sizeof places[0]);
}

const batten_source_place *batten_source_place_at(int index)
{
    assert(index >= 0 && index < batten_source_place_count());
    return &places[index];
}

/* The last number of a place, 14 of "formula 12.7.14", and how many bytes stand before it. */
static long last_number(const char *place, size_t length, size_t *before)
{
    size_t start = length;
    while (start > 0 && place[start - 1] >= '0' && place[start - 1] <= '9')
        start--;
    *before = start;
    return start < length ? strtol(place + start, NULL, 10) : -1;
}

/* Is `place` "formula 12.7.14" within what a source names, "formula 12.7.12-22"? */
static bool within_range(const char *named, size_t length, const char *place)
{
    const char *dash = memchr(named, '-', length);
    size_t before, before_place;
    if (!dash)
        return strlen(place) == length && memcmp(named, place, length) == 0;
    const long low = last_number(named, (size_t)(dash - named), &before);
    const long high = strtol(dash + 1, NULL, 10);
    const long number = last_number(place, strlen(place), &before_place);
    return before == before_place && memcmp(named, place, before) == 0 && low <= number &&
           number <= high;
}

bool batten_feature_has_place(const batten_feature *feature, const batten_source_place *place)
{
    const size_t key = strlen(place->key);
    for (const char *at = feature->source; (at = strchr(at, '[')); at++) {
        const size_t length = strcspn(at + 1, "]");
        if (length > key && strncmp(at + 1, place->key, key) == 0 && at[1 + key] == ' ' &&
            within_range(at + key + 2, length - key - 1, place->place))
            return true;
    }
    return false;
}
