"""The article's five motions, its figures, its statements compared with ours, and its films and a report."""

from hophoop.article.films import article_films
from hophoop.article.reproduce import Reproduction, reproduce
from hophoop.article.scenarios import scenarios
from hophoop.article.statement import Statement
from hophoop.article.statements import statements

__all__ = ["scenarios", "statements", "reproduce", "article_films", "Statement", "Reproduction"]
