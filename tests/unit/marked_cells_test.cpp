#include "core/kernels/marked_cells.hpp"

#include <random>
#include <vector>

#include "support/instruction_sets.hpp"

namespace groundgrid {
namespace {

std::vector<std::uint32_t> visited(const std::vector<std::uint8_t>& cells, std::uint8_t mark) {
  std::vector<std::uint32_t> found;
  append_marked(cells, mark, found);
  return found;
}

class MarkedCells : public testing::OnInstructionSet {};

TEST_P(MarkedCells, OneMarkIsFoundAtEveryPlaceOfEveryLength) {
  for (std::uint32_t count = 1; count <= 135; ++count)
    for (std::uint32_t cell = 0; cell < count; ++cell) {
      std::vector<std::uint8_t> cells(count);
      cells[cell] = 1;
      EXPECT_EQ(visited(cells, 1), std::vector<std::uint32_t>{cell}) << count;
    }
}

TEST_P(MarkedCells, AllOfThemAscending) {
  for (const std::size_t count : {0U, 1U, 63U, 64U, 65U, 4095U, 4096U, 4097U, 9000U}) {
    std::vector<std::uint32_t> all(count);
    for (std::uint32_t cell = 0; cell < count; ++cell) all[cell] = cell;
    EXPECT_EQ(visited(std::vector<std::uint8_t>(count, 4), 4), all);
  }
}

TEST_P(MarkedCells, NoneWithoutMarks) {
  EXPECT_EQ(visited(std::vector<std::uint8_t>(129), 1), std::vector<std::uint32_t>{});
}

TEST_P(MarkedCells, OtherBitsAreNoMark) {
  EXPECT_EQ(visited(std::vector<std::uint8_t>(129, 0xFB), 4), std::vector<std::uint32_t>{});
  for (const std::size_t before : {0U, 60U}) {
    std::vector<std::uint8_t> cells(before + 70, 0x7B);
    cells[before + 1] = 0xFF;
    cells[before + 3] = 0x04;
    cells[before + 9] = 0x84;
    const auto first = static_cast<std::uint32_t>(before);
    EXPECT_EQ(visited(cells, 4), (std::vector<std::uint32_t>{first + 1, first + 3, first + 9}));
    EXPECT_EQ(visited(cells, 0x80), (std::vector<std::uint32_t>{first + 1, first + 9}));
  }
}

TEST_P(MarkedCells, AreAppended) {
  std::vector<std::uint32_t> found{7};
  append_marked(std::vector<std::uint8_t>{0, 1}, 1, found);
  EXPECT_EQ(found, (std::vector<std::uint32_t>{7, 1}));
}

TEST_P(MarkedCells, SameAsCellByCell) {
  std::mt19937 random(1);
  std::vector<std::uint8_t> cells(10'003);
  for (std::uint8_t& cell : cells)
    cell = random() % 4 == 0 ? static_cast<std::uint8_t>(random() % 256) : std::uint8_t{0};
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < cells.size(); ++i)
    if ((cells[i] & 2U) != 0) expected.push_back(i);
  EXPECT_EQ(visited(cells, 2), expected);
}

INSTANTIATE_TEST_SUITE_P(With, MarkedCells, testing::all_instruction_sets(), testing::name_of);

}  // namespace
}  // namespace groundgrid
