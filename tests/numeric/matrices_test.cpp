// Matrices and vectors of two and four numbers against values that are computed here.

#include "closed_form.h"

namespace texbrdf::test {
namespace {

class MatrixTest : public testing::TestWithParam<ClosedForm> {};

TEST_P(MatrixTest, HasItsValue) {
  expect_closed_form(GetParam());
}

#define A "$$ \\mathbf{a} = (1, 2), \\quad \\mathbf{q} = [3, 4] $$"
#define M "$$ M = \\begin{pmatrix} 1 & 2 \\\\ 3 & 5 \\end{pmatrix} $$"
#define N "$$ N = \\begin{bmatrix} 2 & 0 & 1 \\\\ 0 & 3 & 0 \\\\ 1 & 0 & 4 \\end{bmatrix} $$"
#define K \
  "$$ K = \\begin{pmatrix} 2 & 1 & 0 & 3 \\\\ 0 & 1 & 4 & 1 \\\\ 5 & 0 & 1 & 2 \\\\ 1 & 1 & 0 & 1 \\end{pmatrix} $$"

const ClosedForm kVectors[] = {
    {"dot_product", A "$$ f = \\mathbf a \\cdot \\mathbf q $$", 11},
    {"sum_and_length", "$$ f = |(3, 0) + 2 \\begin{pmatrix} 0 \\\\ 2 \\end{pmatrix}| $$", 5},
    {"difference_and_quotient", A "$$ \\mathbf d = (\\mathbf q - \\mathbf a)/4, \\quad f = d_x + 10 d_y $$", 5.5},
    {"sign", A "$$ \\mathbf d = -\\mathbf q, \\quad f = d_x + 10 d_y $$", -43},
    {"components_by_number", A "$$ f = a_1 + 10 a_2 + 100 q_1 $$", 321},
    {"four_numbers", "$$ \\mathbf s = (1, 2, 3, 4), \\quad f = s_x + 10 s_y + 100 s_z + 1000 s_w $$", 4321},
    {"dot_product_of_four", "$$ f = (1, 2, 3, 4) \\cdot (1, 1, 1, 2) $$", 14},
    {"normalised", "$$ \\mathbf u = \\text{normalize}((3, 4)), \\quad f = u_y $$", 0.8},
    {"over_its_length", A "$$ \\mathbf u = \\frac{\\mathbf q}{\\|\\mathbf q\\|}, \\quad f = u_x $$", 0.6},
    {"row_and_column",
     A "$$ f = \\mathbf a^T \\mathbf q + \\mathbf a^{\\mathsf T} \\mathbf a + \\mathbf q^\\top \\mathbf q $$",
     11 + 5 + 25},
    {"column_of_three", "$$ f = \\omega_i^T \\omega_o $$", 0.768},
    {"inner_product", A "$$ f = \\langle \\mathbf a, \\mathbf q \\rangle $$", 11},
};

const ClosedForm kMatrices[] = {
    {"times_vector", A M "$$ \\mathbf w = M \\mathbf q, \\quad f = w_x + 100 w_y $$", 11 + 100 * 29},
    {"quadratic_form", A M "$$ f = \\mathbf q^T M \\mathbf q $$", 3 * 11 + 4 * 29},
    {"vector_before_it", A M "$$ \\mathbf w = (\\mathbf q M)^T, \\quad f = w_x + 100 w_y $$", 15 + 100 * 26},
    {"row_environment", M "$$ f = \\begin{pmatrix} 3 & 4 \\end{pmatrix} M \\begin{pmatrix} 3 \\\\ 4 \\end{pmatrix} $$",
     3 * 11 + 4 * 29},
    {"entries", M "$$ f = M_{11} + 10 M_{1,2} + 100 M_{21} + 1000 M_{22} $$", 5321},
    {"sum", M "$$ W = 2 M - M/2 + (-M) + M \\cdot 3, \\quad f = W_{22} $$", 17.5},
    {"product", M "$$ W = M M, \\quad f = W_{11} + 100 W_{21} $$", 7 + 100 * 18},
    {"transposed", M "$$ W = M^\\intercal, \\quad f = W_{12} $$", 3},
    {"inverse_of_two", M "$$ W = M^{-1}, \\quad f = W_{11} + 10 W_{12} + 100 W_{21} + 1000 W_{22} $$",
     -5 + 10 * 2 + 100 * 3 - 1000},
    {"inverse_transposed", M "$$ W = M^{-T}, \\quad f = W_{12} $$", 3},
    {"determinant", M "$$ f = \\det M + 10 \\det(M) + 100 |M| + 1000 \\det M^{-1} $$", -1111},
    {"determinant_in_bars",
     "$$ f = \\begin{vmatrix} 1 & 2 \\\\ 3 & 5 \\end{vmatrix} + 10 \\left| \\begin{matrix} 1 & 2 \\\\ 3 & 5 \\end{matrix} "
     "\\right| $$",
     -11},
    {"determinant_of_three", N "$$ f = \\det N $$", 21},
    {"determinant_of_four", K "$$ f = \\det K $$", -34},
    {"inverse_of_three", N "$$ W = N^{-1}, \\quad f = W_{11} + 10 W_{13} + 100 W_{22} $$",
     4.0 / 7 - 10.0 / 7 + 100.0 / 3},
    {"inverse_of_four", K "$$ W = K K^{-1}, \\quad f = W_{11} + W_{22} + W_{33} + W_{44} + 100 (W_{12} + W_{43}) $$",
     4},
    {"trace", N "$$ f = \\operatorname{tr}(N) + 10\\, \\mathrm{Tr}(N N) $$", 9 + 10 * 31},
    {"outer_product", A "$$ W = \\mathbf a \\mathbf q^T, \\quad f = W_{12} + 10 \\det W + 100 \\operatorname{tr}(W) $$",
     4 + 1100},
    {"of_a_singular_one", "$$ W = \\begin{pmatrix} 1 & 2 \\\\ 2 & 4 \\end{pmatrix}^{-1}, \\quad f = 1/W_{11} $$", 0},
    {"in_brackets", "$$ f = \\det\\left( \\begin{array}{cc} 1 & 2 \\\\ 3 & 5 \\end{array} \\right) $$", -1},
    {"small", "$$ f = \\det\\bigl[\\begin{smallmatrix} 1 & 2 \\\\ 3 & 5 \\end{smallmatrix}\\bigr] $$", -1},
};

const ClosedForm kBesideTheRest[] = {
    {"projection_of_a_direction",
     "$$ P = \\begin{pmatrix} 1 & 0 & 0 \\\\ 0 & 0 & 1 \\end{pmatrix}, \\quad \\mathbf s = P \\omega_i, \\quad "
     "f = s_x + 10 s_y $$",
     0.6 + 8},
    {"rotation_of_a_direction",
     "$$ R = \\begin{pmatrix} 0 & -1 & 0 \\\\ 1 & 0 & 0 \\\\ 0 & 0 & 1 \\end{pmatrix}, \\quad "
     "f = (R \\omega_i) \\cdot \\omega_o $$",
     -0.168 + 0.768},
    {"colour", "$$ f = \\begin{pmatrix} 0 & 2 & 0 \\\\ 1 & 0 & 0 \\\\ 0 & 0 & 1 \\end{pmatrix} (0.1, 0.4, 0.9) $$",
     0.8},
    {"mirror", "$$ H = \\vec{n} \\vec{n}^T, \\quad f = (2 H \\omega_i - \\omega_i) \\cdot \\omega_o $$", 0.768},
    {"cases",
     M "$$ W = \\begin{cases} M & \\theta_i > 1.5 \\\\ 2M & \\text{otherwise} \\end{cases}, \\quad f = W_{21} $$", 6},
    {"result_of_a_function",
     A "$$ R(x) = \\begin{pmatrix} \\cos x & -\\sin x \\\\ \\sin x & \\cos x \\end{pmatrix}, \\quad "
       "f = \\mathbf q^T R(0.3) \\mathbf q $$",
     25 * std::cos(0.3)},
    {"derivative",
     A "$$ x = 0.3, \\quad R = \\begin{pmatrix} \\cos x & -\\sin x \\\\ \\sin x & \\cos x \\end{pmatrix} $$"
       "$$ f = \\frac{d}{dx}(\\mathbf a^T R \\mathbf q) $$",
     -11 * std::sin(0.3) + 2 * std::cos(0.3)},
    {"integral", "$$ f = \\int_0^1 (x, 1) \\cdot (x, x)\\,dx $$", 1.0 / 3 + 0.5},
    {"sum", "$$ f = \\sum_{k=1}^{20} |(3k, 4k)| $$", 1050},
    {"sum_of_terms", A "$$ S = \\sum_{k \\in \\{1, 2\\}} k^2 \\mathbf a \\cdot \\mathbf q, \\quad f = S $$", 55},
    {"exponent_that_is_a_number", "$$ T = 3, \\quad f = 2^T $$", 8},
};

INSTANTIATE_TEST_SUITE_P(Vectors, MatrixTest, testing::ValuesIn(kVectors), closed_form_name);
INSTANTIATE_TEST_SUITE_P(Matrices, MatrixTest, testing::ValuesIn(kMatrices), closed_form_name);
INSTANTIATE_TEST_SUITE_P(BesideTheRest, MatrixTest, testing::ValuesIn(kBesideTheRest), closed_form_name);

}  // namespace
}  // namespace texbrdf::test
