# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nothing grows beyond what can be read at one sitting, and the measures measure."""
from measures import LONGEST_HEADER, LONGEST_SOURCE, cpp_functions, python_functions
from source_tree import faults_in, files

CPP_SOURCES = files(".h", ".cpp")


def file_faults(path):
    limit = LONGEST_HEADER if path.suffix == ".h" else LONGEST_SOURCE
    count = len(path.read_text().splitlines())
    return [f"{count} lines, {limit} at most"] if count > limit else []


def function_faults(path):
    measure = python_functions if path.suffix == ".py" else cpp_functions
    return [fault for function in measure(path.read_text()) for fault in function.faults()]


def test_files_stay_short():
    assert faults_in(CPP_SOURCES + files(".py"), file_faults) == {}


def test_cpp_functions_stay_small():
    assert faults_in(CPP_SOURCES, function_faults) == {}


def test_python_functions_stay_small():
    assert faults_in(files(".py"), function_faults) == {}


def test_a_long_file_is_noticed(tmp_path):
    (tmp_path / "long.h").write_text("\n" * 151)
    (tmp_path / "short.cpp").write_text("\n" * 600)
    assert file_faults(tmp_path / "long.h") == ["151 lines, 150 at most"]
    assert file_faults(tmp_path / "short.cpp") == []


def test_a_long_python_function_is_noticed():
    head = 'class A:\n    def f(self, a):\n        """Adds.\n\n        Nothing else."""\n'
    text = head + "        a += 1\n" * 40 + "        return a\n"
    (function,) = python_functions(text)
    assert function.lines == 42
    assert function.faults() == ["line 2: f has 42 lines"]


CPP = """
#include <vector>
namespace sheetmorph
{
struct Options
{
    std::vector<int> ids{1, 2};
    int twice() const { return 2 * ids[0]; }
};
template <class T, class S>
int many(const std::map<int, T>& a, int b, int c, S d, int e = f(1, 2))
{
    if (a)
    {
        return "}" == text;  // }
    }
    return 0;
}
Session::Session(int a)
    : a_(a), b_{a}
{
LINES}
int after(int a)
{
    return a;
}
}  // namespace sheetmorph
"""


def test_cpp_functions_are_found_with_their_sizes():
    found = {
        f.name: f for f in cpp_functions(CPP.replace("LINES", "    run([](int i) { go(i); });\n"))
    }
    assert set(found) == {"twice", "many", "Session::Session", "after"}
    assert (found["many"].line, found["many"].lines) == (11, 8)


def test_a_long_cpp_function_is_noticed():
    found = cpp_functions(CPP.replace("LINES", "    ++a;\n" * 37))
    long = [fault for function in found for fault in function.faults() if "lines" in fault]
    assert long == ["line 19: Session::Session has 41 lines"]


def test_functions_are_found_in_the_kernel():
    kernel = [path for path in CPP_SOURCES if path.suffix == ".cpp"]
    assert sum(len(cpp_functions(path.read_text())) for path in kernel) >= len(kernel) > 10
