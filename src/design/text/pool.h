/* Memory that lives and dies with a document: taken piece by piece, given back at once. */
#ifndef BAT_DESIGN_POOL_H
#define BAT_DESIGN_POOL_H
#include "base/base.h"

/* Begin with {NULL}. */
typedef struct {
    struct bat_block *last;
} bat_pool;

/* Zeroed memory for `count` items; NULL and the message when there is none. */
void *bat_pool_array(bat_pool *pool, size_t count, size_t size);
/* A copy with a zero byte after it; NULL when there is no memory. */
char *bat_pool_copy(bat_pool *pool, const char *bytes, size_t length);
void bat_pool_free(bat_pool *pool);

#endif
