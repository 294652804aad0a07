#define TEXBRDF_LANES 16
#define TEXBRDF_RUN run_avx512
#include "eval/kernels/kernel_body.h"
