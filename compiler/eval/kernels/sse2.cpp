#define TEXBRDF_LANES 4
#define TEXBRDF_RUN run_sse2
#include "eval/kernels/kernel_body.h"
