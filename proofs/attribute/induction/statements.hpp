// Which lemmas each law follows from, of the orders' parts.
#pragma once

#include "proofs/attribute/induction/formula.hpp"
#include "proofs/attribute/induction/names.hpp"

namespace mmverify::proofs::attribute::induction {

std::vector<Statement> w_minor_statements(const Parts<Counted>& by);
std::vector<Statement> u_major_statements(const Parts<Counted>& by);
std::vector<Statement> bird_statements(const Parts<Counted>& by);
std::vector<Statement> faces_statements(const Parts<Counted>& by);

}  // namespace mmverify::proofs::attribute::induction
