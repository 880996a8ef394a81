/* Maps of chains that keep their shapes: every span becomes one of its own kind. */
#ifndef BAT_SPLINE_CHAIN_TRANSFORM_H
#define BAT_SPLINE_CHAIN_TRANSFORM_H
#include "spline/chain/chain.h"

batten_status bat_chain_check_span(int dimension, const batten_span *span, int index);
batten_status bat_chain_copy(const batten_chain *chain, batten_chain **out);

#endif
