"""What a rule answers."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Finding:
    file: str
    line: int  # 0: the file as a whole.
    message: str

    def __str__(self):
        return f"{self.file}:{self.line}: {self.message}" if self.line else f"{self.file}: {self.message}"
