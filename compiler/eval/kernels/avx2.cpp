#define TEXBRDF_LANES 8
#define TEXBRDF_RUN run_avx2
#include "eval/kernels/kernel_body.h"
