"""Rows of `ours`, `theirs`, their ratio and what the ratio should be; and the count of aims met."""

import dataclasses
import statistics

median = statistics.median


@dataclasses.dataclass(frozen=True)
class Aim:
    sign: str
    number: float

    def met_by(self, number):
        return number <= self.number if self.sign == "<=" else number >= self.number

    def __str__(self):
        return f"{self.sign} {self.number:.3g}"


def at_most(number):
    return Aim("<=", number)


def at_least(number):
    return Aim(">=", number)


def seconds(number):
    for unit, size in (("s", 1.0), ("ms", 1e-3)):
        if number >= size:
            return f"{number / size:.3g} {unit}"
    return f"{number / 1e-6:.3g} us"


class Table:
    """Prints as it goes: a benchmark takes minutes, and the reader may as well watch."""

    def __init__(self, judge):
        self.judge = judge
        self.met, self.missed = 0, []
        self.busy = 0
        self.title = self.group = ""
        self.disturbed = False

    def facts(self, facts):
        for name, fact in facts.items():
            print(f"{name:<14} {fact}")

    def section(self, title, explanation):
        self.title = title
        print(f"\n{title}\n  {explanation}")
        print(f"    {'':<36} {'ours':>10} {'theirs':>10} {'ratio':>8}  {'spread':<13} {'aim':<9} met")

    def head(self, words, others=0.0):
        """`others` is the share of the machine that other programs took, where that falsifies the rows that follow."""
        self.group = words
        self.disturbed = others > 0.1
        print(f"  {words}", flush=True)

    def row(self, label, ours, theirs, ratios, aim, judged=None):
        """`judged` is the number that the aim is about; the median ratio unless said."""
        ratio = median(ratios)
        low, high = min(ratios), max(ratios)
        spread = f"{low:.2f} .. {high:.2f}" if high > 1.1 * low else ""
        verdict = ""
        if aim is not None and self.judge:
            if self.disturbed:
                self.busy += 1
                verdict = "busy"
            elif aim.met_by(ratio if judged is None else judged):
                self.met += 1
                verdict = "yes"
            else:
                self.missed.append(f"{self.title}: {self.group}: {label}")
                verdict = "NO"
        print(f"    {label:<36} {ours:>10} {theirs:>10} {ratio:>8.2f}  {spread:<13} "
              f"{'' if aim is None else str(aim):<9} {verdict}".rstrip(), flush=True)

    def times(self, label, ours, theirs, aim):
        """Seconds; the ratio says how many times longer ours take."""
        self.row(label, seconds(median(ours)), seconds(median(theirs)), [a / b for a, b in zip(ours, theirs)], aim)

    def speedup(self, label, ours, theirs, aim):
        """Seconds; the ratio says how many times faster ours are."""
        self.row(label, seconds(median(ours)), seconds(median(theirs)), [b / a for a, b in zip(ours, theirs)], aim)

    def share(self, label, part, whole):
        """Seconds of a part and of the whole."""
        self.row(label, seconds(max(0.0, median(part))), seconds(median(whole)),
                 [median(a / b for a, b in zip(part, whole))], None)

    def rates(self, label, ours, theirs, aim):
        """Seconds of one kernel evaluation, shown as billions a second; how many times faster ours are."""
        self.row(label, f"{1e-9 / median(ours):.2f}", f"{1e-9 / median(theirs):.2f}",
                 [b / a for a, b in zip(ours, theirs)], aim)

    def sizes(self, label, ours, theirs, aim):
        self.row(label, f"{ours:.2f}", f"{theirs:.2f}", [ours / theirs], aim)

    def errors(self, label, ours, theirs, aim):
        self.row(label, f"{ours:.1e}", f"{theirs:.1e}", [ours / theirs], aim, judged=ours)

    def summary(self, load):
        print()
        if not self.judge:
            print("aims           not judged: a quick run only shows that everything runs")
        else:
            busy = f", {self.busy} not judged: others took more than a tenth of the machine" if self.busy else ""
            print(f"aims           {self.met} met, {len(self.missed)} missed{busy}")
            for missed in self.missed:
                print(f"    missed     {missed}")
        print(f"load           {load}")
