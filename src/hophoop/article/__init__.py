"""The article's five motions, its figures and statements beside ours, and one report of it all."""

from hophoop.article.reproduce import Reproduction, reproduce
from hophoop.article.scenarios import scenarios
from hophoop.article.statement import Statement
from hophoop.article.statements import statements

__all__ = ["scenarios", "statements", "reproduce", "Statement", "Reproduction"]
